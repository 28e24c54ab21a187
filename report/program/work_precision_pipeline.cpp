#include "report/program/work_precision_pipeline.h"

#include <filesystem>

#include "engine/study/work_precision/run_work_precision.h"
#include "report/study/work_precision/work_precision_page.h"
#include "report/study/work_precision/work_precision_study.h"

namespace plumb {

namespace fs = std::filesystem;

Study quick_study(const LoadedCase& loaded, Journal& journal, Console& console) {
  Runner runner(journal,
                [&](const std::string& part, double share) { console.progress("study: " + part, share); });
  Study study{loaded, run_work_precision(loaded.spec, true, runner, loaded.given_runs)};
  console.end_progress();
  return study;
}

void write_study(const Study& study, OutputFolder& folder) {
  folder.write(study_file_name, encode_study(study));
}

std::optional<Study> study_beside(const std::string& run_path) {
  std::error_code ignored;
  const fs::path folder =
      fs::is_directory(run_path, ignored) ? fs::path(run_path) : fs::path(run_path).parent_path();
  const fs::path file = folder / study_file_name;
  if (!fs::exists(file, ignored)) return {};
  return read_study(file.string());
}

Study find_study(const std::string& path) {
  std::error_code ignored;
  return read_study(fs::is_directory(path, ignored) ? (fs::path(path) / study_file_name).string() : path);
}

bool is_study(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    return fs::exists(fs::path(path) / study_file_name, ignored) &&
           !fs::exists(fs::path(path) / "run.h5", ignored);
  return fs::path(path).filename() == study_file_name;
}

}  // namespace plumb
