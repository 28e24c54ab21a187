#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/errors.h"

namespace plumb::fuzz {

/// What a reader must keep whatever it is given, and did not.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws BrokenPromise with `what` unless it is kept.
void promise(bool kept, const std::string& what);

/// That all of `values` are finite.
void promise_finite(std::span<const double> values, const std::string& what);

/// That an error is one line of UTF-8 without control characters, of bounded length.
void promise_message(std::string_view message);

/// What was last refused, and why.
std::string& last_refusal();

/// Runs `read`. False where it refuses with one of the exceptions that it may throw; every other one goes on.
/// The message of an InputError is held to promise_message(): others are made one line where they are shown.
template <class... Refusals, class Read>
bool reads(const Read& read) {
  try {
    read();
    return true;
  } catch (const std::exception& error) {
    if (!(... || (dynamic_cast<const Refusals*>(&error) != nullptr))) throw;
    last_refusal() = error.what();
    if (dynamic_cast<const InputError*>(&error) != nullptr) promise_message(error.what());
    return false;
  }
}

/// A file in memory for readers that take no less, emptied and filled anew for every input.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& name);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& hold(std::string_view bytes) const;  ///< the file's path
  std::string text() const;

 private:
  std::string path_;
};

/// A reader, what is promised of it, and what to begin with.
struct Target {
  std::string_view name;  ///< also of its folder below corpus/, and of its dictionary
  /// Reads an input and throws where a promise is broken. True where the input was accepted.
  bool (*feed)(std::string_view input) = nullptr;
  /// Inputs that are accepted, the most of them from the program's own writers.
  std::vector<std::string> (*seeds)() = nullptr;
};

/// Every target.
std::span<const Target> targets();

extern const Target case_target, reference_target, override_target, expression_target, csv_target,
    hdf5_target, packed_target, results_target, study_json_target, assessment_target, choice_target,
    journal_target, manifest_target, png_target, difference_target, command_line_target, unit_target;

}  // namespace plumb::fuzz
