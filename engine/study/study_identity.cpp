#include "engine/study/study_identity.h"

#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "engine/run/provenance.h"

namespace plumb {
namespace {

uLong added(uLong sum, std::string_view bytes) {
  return crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

std::string now(const char* wanted) {
  for (const auto& [name, value] : provenance_now())
    if (name == wanted) return value;
  return {};
}

/// Of the file that this program was started from.
std::string sum_of_program() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::array<char, 1 << 16> bytes;
  uLong sum = 0;
  while (file.read(bytes.data(), bytes.size()) || file.gcount() > 0)
    sum = added(sum, {bytes.data(), static_cast<std::size_t>(file.gcount())});
  return fmt::format("{:08x}", sum);
}

std::string program_in_words() {
  const std::string revision = now("revision");
  std::string words = fmt::format("revision {}, {}, {}", revision, now("compiler"), now("flags"));
  // Two programs of one revision may differ where the checkout has changes of its own.
  if (revision == "unknown" || revision.ends_with("-dirty"))
    words += fmt::format(", program {}", sum_of_program());
  return words;
}

}  // namespace

StudyIdentity study_identity(const CaseSource& source) {
  uLong sum = 0;
  std::size_t size = 0;
  const auto add = [&](std::string_view text) {
    sum = added(added(sum, text), std::string_view("\0", 1));
    size += text.size() + 1;
  };
  add(source.file.text);
  for (const std::string& override_text : source.overrides) add(override_text);
  for (const NamedText& reference : source.references) add(reference.text);
  for (const NamedText& run : source.given_runs) add(run.text);
  static const std::string program = program_in_words();
  return {fmt::format("{:08x}-{}", sum, size), std::filesystem::path(source.file.name).filename().string(),
          program};
}

const Machine& this_machine() {
  static const Machine machine = [] {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) name = {'?'};
    return Machine{name.data(), now("processor"), now("revision")};
  }();
  return machine;
}

}  // namespace plumb
