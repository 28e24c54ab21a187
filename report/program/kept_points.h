#pragma once

#include <string>

#include "engine/run/output_folder.h"
#include "engine/study/runner.h"
#include "report/program/console.h"

namespace plumb {

/// The journal in a finished output folder, and what it is called beside a folder in the making.
inline constexpr const char* points_file_name = "points.jsonl";
inline constexpr const char* unfinished_points = ".unfinished.jsonl";

/// What the studies of one command have computed, for an output folder: kept beside it while it is made, so
/// that the same command goes on where it was interrupted.
class KeptPoints {
 public:
  /// Says what it goes on with. Throws OutputError where it cannot be kept.
  KeptPoints(const std::string& folder, const CaseSource& source, Console& console);

  /// A file without a point is worth nothing to anyone.
  ~KeptPoints();
  KeptPoints(const KeptPoints&) = delete;
  KeptPoints& operator=(const KeptPoints&) = delete;

  /// Takes over what an output folder has of the same case: that of `plumb run`, or of a share.
  void take_over_from(const std::string& folder);

  Journal& journal() { return journal_; }
  const StudyIdentity& identity() const { return identity_; }

  /// Puts them into the folder, for studies to come, and for --merge, even where there are none.
  void write(OutputFolder& folder) const;

  /// Says that they stay, for the same command to go on from.
  void say_kept(Console& console) const;

  /// The folder is in place.
  void remove() { journal_.remove(); }

 private:
  StudyIdentity identity_;
  Journal journal_;
};

}  // namespace plumb
