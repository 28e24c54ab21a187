#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/study/reference/certified_reference.h"
#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// What a study under way has done, so that one that is interrupted can go on from there: a line of JSON a
/// run behind its check sum, written as soon as it is done. A last line that was cut off is left out, and so
/// is any whose check sum is not its own. Safe to use from several threads.
class StudyJournal {
 public:
  /// Kept in memory only.
  StudyJournal() = default;
  /// Goes on with the file at `path` if it is of the same `identity`, and starts it anew otherwise.
  /// Throws OutputError if it cannot be written, here and in every `add`, and for a link or what is no
  /// journal, which stay as they are.
  StudyJournal(std::string path, const std::string& identity);
  ~StudyJournal();
  StudyJournal(const StudyJournal&) = delete;
  StudyJournal& operator=(const StudyJournal&) = delete;

  /// A run that is done, as it was added; its repeats are not in it.
  std::optional<StudyRun> find_run(const MethodSpec& method, int elements) const;
  void add_run(const StudyRun& run);

  /// The repeats of a run, empty if they are not done.
  std::vector<double> find_seconds(const StudyRun& run) const;
  void add_seconds(const StudyRun& run);

  /// A reference without its trajectory.
  std::optional<StudyReference> find_reference(int elements) const;
  void add_reference(const StudyReference& reference);

  /// How many lines were found in the file, and how many of it are damaged: what they held is done again.
  std::size_t found() const { return found_; }
  std::size_t damaged() const { return damaged_; }
  const std::string& path() const { return path_; }

  /// Removes the file: the study is done and its results are written.
  void remove();

 private:
  void go_on();
  std::string read(long size) const;
  void append(const std::string& json);
  void write(std::string_view rest);
  /// False if the line is damaged.
  bool take(const std::string& line);
  [[noreturn]] void fail(const std::string& why) const;

  std::string path_;
  std::string identity_;
  int file_ = -1;
  std::size_t found_ = 0;
  std::size_t damaged_ = 0;
  mutable std::mutex guard_;
  std::map<std::string, StudyRun> runs_;
  std::map<std::string, std::vector<double>> seconds_;
  std::map<int, StudyReference> references_;
};

/// What a journal must have been made of for its runs to count: case text and overrides, the form of the
/// study, the program and the processor.
std::string study_identity(const CaseSource& source, bool quick);

}  // namespace plumb
