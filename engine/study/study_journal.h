#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/input/case_source.h"
#include "engine/study/study_reference.h"
#include "engine/study/work_precision.h"

namespace plumb {

/// What a study under way has done, so that one that is interrupted can go on from there: a line of JSON a
/// run, written as soon as it is done. A last line that was cut off is left out. Safe to use from several
/// threads.
class StudyJournal {
 public:
  /// Kept in memory only.
  StudyJournal() = default;
  /// Goes on with the file at `path` if it is of the same `identity`, and starts it anew otherwise.
  /// Throws OutputError if it cannot be written, here and in every `add`.
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

  /// How many lines were found in the file.
  std::size_t found() const { return found_; }
  const std::string& path() const { return path_; }

  /// Removes the file: the study is done and its results are written.
  void remove();

 private:
  void append(const std::string& line);
  void take(const std::string& line);

  std::string path_;
  int file_ = -1;
  std::size_t found_ = 0;
  mutable std::mutex guard_;
  std::map<std::string, StudyRun> runs_;
  std::map<std::string, std::vector<double>> seconds_;
  std::map<int, StudyReference> references_;
};

/// What a journal must have been made of for its runs to count: case text and overrides, the form of the
/// study, the program and the processor.
std::string study_identity(const CaseSource& source, bool quick);

}  // namespace plumb
