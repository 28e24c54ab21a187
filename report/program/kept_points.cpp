#include "report/program/kept_points.h"

#include <fmt/format.h>

#include <filesystem>

namespace plumb {
KeptPoints::KeptPoints(const std::string& folder, const CaseSource& source, Console& console)
    : identity_(study_identity(source)), journal_(folder + unfinished_points, identity_) {
  if (journal_.found() > 0) console.line("going on with what " + journal_.path() + " holds");
  if (!journal_.locked())
    console.remark(journal_.path() + " cannot be locked on its file system: let no other plumb work on it");
  if (journal_.damaged() > 0)
    console.remark(
        fmt::format("{} has {}; what is missing is done again", journal_.path(),
                    counted(static_cast<long>(journal_.damaged()), "damaged line", "damaged lines")));
}

KeptPoints::~KeptPoints() {
  if (journal_.empty()) journal_.remove();
}

void KeptPoints::take_over_from(const std::string& folder) {
  const std::filesystem::path file = std::filesystem::path(folder) / points_file_name;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) journal_.take_over(file.string(), identity_);
}

void KeptPoints::write(OutputFolder& folder) const {
  folder.write(points_file_name, journal_.text(identity_));
}

void KeptPoints::say_kept(Console& console) const {
  console.end_progress();
  if (!journal_.empty())
    console.remark("what is done is kept in " + journal_.path() + "; the same command goes on from there");
}

}  // namespace plumb
