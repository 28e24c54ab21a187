#include "tests/fuzz/target.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace plumb::fuzz {

void promise(bool kept, const std::string& what) {
  if (!kept) throw BrokenPromise(what);
}

void promise_finite(std::span<const double> values, const std::string& what) {
  for (const double value : values) promise(std::isfinite(value), fmt::format("{} is {}", what, value));
}

void promise_message(std::string_view message) {
  constexpr std::size_t longest = 1500;
  promise(!message.empty(), "an error says nothing");
  promise(message.size() <= longest, fmt::format("an error of {} bytes: {}", message.size(), message));
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  promise(std::none_of(message.begin(), message.end(), is_control),
          fmt::format("an error with control characters: {}", message));
}

std::string& last_refusal() {
  static std::string why;
  return why;
}

MemoryFile::MemoryFile(const std::string& name)
    : path_(fmt::format("/dev/shm/plumb-fuzz-{}-{}", ::getpid(), name)) {}

MemoryFile::~MemoryFile() {
  std::remove(path_.c_str());
}

const std::string& MemoryFile::hold(std::string_view bytes) const {
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  promise(file.flush().good(), path_ + " cannot be written");
  return path_;
}

std::string MemoryFile::text() const {
  std::ostringstream text;
  text << std::ifstream(path_, std::ios::binary).rdbuf();
  return text.str();
}

std::span<const Target> targets() {
  static const std::array all{
      case_target,    reference_target, override_target, expression_target, unit_target,        csv_target,
      hdf5_target,    packed_target,    results_target,  study_json_target, assessment_target,  choice_target,
      journal_target, manifest_target,  png_target,      difference_target, command_line_target};
  return all;
}

}  // namespace plumb::fuzz
