#include "engine/base/job.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/base/errors.h"

namespace plumb {
namespace {

constexpr const char* module_name = "libplumb_mpi.so";

int number_in(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? 0 : std::atoi(value);
}

/// As mpirun of Open MPI, and srun --mpi=pmix, tell it those that they start.
bool is_one_of_several() {
  return number_in("OMPI_COMM_WORLD_SIZE") > 1 ||
         (std::getenv("PMIX_RANK") != nullptr && number_in("SLURM_NTASKS") > 1);
}

/// Not linked, as MPI alone takes longer to load than all else of the program.
std::unique_ptr<Job> open_job() {
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  std::string why;
  for (const auto& folder : {program, program / PLUMB_MODULES}) {
    void* module = ::dlopen((folder / module_name).c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (module == nullptr) {
      why = ::dlerror();
      continue;
    }
    using Open = Job* (*)();
    if (const auto open = reinterpret_cast<Open>(::dlsym(module, "plumb_open_job")))
      return std::unique_ptr<Job>(open());
  }
  throw UsageError(fmt::format("this is one of several processes of an MPI job, and {} cannot be opened: {}",
                               module_name, why));
}

}  // namespace

Job* job_of_process() {
  static const std::unique_ptr<Job> job = is_one_of_several() ? open_job() : nullptr;
  return job.get();
}

}  // namespace plumb
