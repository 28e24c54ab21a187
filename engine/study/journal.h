#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/study/study_identity.h"

namespace plumb {

/// What a study under way has computed, so that one that is interrupted can go on from there, and that shares
/// of it can be put together: a line of JSON a point behind its check sum, written as soon as it is done. A
/// last line that was cut off is left out, and so is any whose check sum is not its own, as where two
/// machines wrote over one another. Safe to use from several threads, and from a process and those that it
/// has forked.
class Journal {
 public:
  /// Kept in memory only.
  Journal() = default;
  /// Goes on with the file at `path` if it is of the same `identity`, and starts it anew otherwise.
  /// Throws OutputError if it cannot be written, here and in every `add`, if another program is at work on
  /// it, and for a link or what is no journal, which stay as they are.
  Journal(std::string path, StudyIdentity identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Takes over what the file of another journal of the same `identity` holds, if it is one.
  void take_over(const std::string& file, const StudyIdentity& identity);

  /// The same, but throws InputError that names the file, and in what it differs, if it is none: another
  /// case, another program, no journal. Of points that are known already the first result stays.
  void merge(const std::string& file, const StudyIdentity& identity);

  /// The result of a point as JSON, if it is known.
  std::optional<std::string> find(const std::string& key) const;
  /// Where a known point was computed.
  const Machine& machine_of(const std::string& key) const;
  /// How long it took there, s of the processor; -1: not known.
  double seconds_of(const std::string& key) const;
  /// Takes JSON without a line break.
  void add(const std::string& key, const std::string& result, double seconds = -1,
           const Machine& on = this_machine());

  bool empty() const;
  std::size_t points() const;
  /// Each machine, and how many of the points it computed.
  std::vector<std::pair<Machine, std::size_t>> machines() const;

  /// How many points were found in the file, and how many of its lines are damaged: what they held is done
  /// again.
  std::size_t found() const { return found_; }
  std::size_t damaged() const { return damaged_; }
  /// False where the file system has no locks, so that a second program on the same file is not seen.
  bool locked() const { return locked_; }
  const std::string& path() const { return path_; }

  /// All that it holds, or the points that are `wanted`, as the text of a journal; `missing` are keys that it
  /// is to name as not there.
  std::string text(const StudyIdentity& identity, const std::function<bool(const std::string&)>& wanted = {},
                   const std::vector<std::string>& missing = {}) const;
  /// The keys that what was merged names as not there.
  const std::set<std::string>& missing() const { return missing_; }

  /// Removes the file: the study is done and its results are written.
  void remove();

 private:
  struct Result {
    std::string text;
    double seconds;
    std::size_t machine;  // of machines_
    std::size_t source;   // the how many-th file it is from; 0: none
  };
  class Lines;

  void go_on();
  void write(std::string_view rest);
  std::size_t number_of(const Machine& machine);
  [[noreturn]] void fail(const std::string& why) const;

  std::string path_;
  StudyIdentity identity_;
  int file_ = -1;
  bool locked_ = true;
  std::size_t found_ = 0;
  std::size_t damaged_ = 0;
  mutable std::mutex guard_;
  std::vector<Machine> machines_;
  std::set<std::size_t> said_;  // of machines_, in the file
  std::size_t sources_ = 0;
  std::map<std::string, Result> results_;
  std::set<std::string> missing_;
};

}  // namespace plumb
