#include "engine/run/provenance.h"

#include <fmt/chrono.h>
#include <hdf5.h>
#include <sundials/sundials_version.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace plumb {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(':'); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

std::string operating_system() {
  std::string name = "unknown";
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("PRETTY_NAME=\"")) name = line.substr(13, line.size() - 14);
  utsname kernel{};
  if (uname(&kernel) == 0) name += fmt::format(", {} {} {}", kernel.sysname, kernel.release, kernel.machine);
  return name;
}

std::string sundials_version() {
  char version[64];
  return SUNDIALSGetVersion(version, sizeof version) == 0 ? version : "unknown";
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  if (H5get_libversion(&major, &minor, &release) < 0) return "unknown";
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace

Provenance provenance_now() {
  Provenance result{{"program", "Plumb " PLUMB_VERSION},
                    {"revision", PLUMB_REVISION},
                    {"compiler", PLUMB_COMPILER},
                    {"flags", PLUMB_FLAGS},
                    {"libraries at build", PLUMB_LIBRARIES},
                    {"SUNDIALS at run time", sundials_version()},
                    {"HDF5 at run time", hdf5_version()},
                    {"processor", cpu_model()},
                    {"processors", std::to_string(std::thread::hardware_concurrency())},
                    {"system", operating_system()},
                    {"made at", fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)))}};
  return result;
}

}  // namespace plumb
