// The entry of libFuzzer: plumb_fuzz --target=NAME [what libFuzzer takes], or --seeds=FOLDER, which writes
// what each target begins with to FOLDER/NAME, or --targets, which lists their names.

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;
using plumb::fuzz::Target;

const Target* chosen = nullptr;
bool says = false;

void write_seeds(const fs::path& folder) {
  for (const Target& target : plumb::fuzz::targets()) {
    fs::create_directories(folder / target.name);
    int number = 0;
    for (const std::string& seed : target.seeds())
      std::ofstream(folder / target.name / fmt::format("seed-{:02}", number++), std::ios::binary) << seed;
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  for (int k = 1; k < *count; ++k) {
    const std::string_view word = (*arguments)[k];
    if (word.starts_with("--seeds=")) {
      write_seeds(word.substr(word.find('=') + 1));
      std::exit(0);
    }
    for (const Target& target : plumb::fuzz::targets()) {
      if (word == "--targets") fmt::print("{}\n", target.name);
      if (word == fmt::format("--target={}", target.name)) chosen = &target;
    }
    if (word == "--targets") std::exit(0);
    says = says || word == "--say";
  }
  if (chosen == nullptr) {
    fmt::print(stderr, "plumb_fuzz: --target=NAME must name one of --targets\n");
    std::exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const bool accepted = chosen->feed({reinterpret_cast<const char*>(bytes), size});
  if (says) fmt::print(stderr, "{}\n", accepted ? "accepted" : plumb::fuzz::last_refusal());
  return 0;
}
