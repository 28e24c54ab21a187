#include "report/program/assessment_pipeline.h"

#include <filesystem>

#include "engine/base/document_sum.h"
#include "engine/base/file_text.h"
#include "engine/study/uncertainty/run_budget.h"
#include "engine/study/uncertainty/run_uncertainty.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* assessment_file_name = "assessment.json";

}  // namespace

Assessment assess(const Run& run, Journal& journal, Stages& stages, Console& console) {
  Assessment assessment;
  Runner runner(journal, [&](const std::string& part, double share) { console.progress(part, share); });
  if (run.loaded.spec.error_budget) {
    stages.begin("error budget");
    assessment.error_budget = run_budget(run.loaded, runner);
    console.end_progress();
  }
  if (run.loaded.spec.uncertainty) {
    stages.begin("uncertainty");
    assessment.uncertainty =
        run_uncertainty(run, runner, assessment.error_budget ? &*assessment.error_budget : nullptr);
    console.end_progress();
  }
  return assessment;
}

void write_assessment(const Assessment& assessment, OutputFolder& folder) {
  if (!assessment.empty()) folder.write(assessment_file_name, encode_assessment(assessment));
}

Assessment assessment_beside(const std::string& run_path, const Run& run) {
  std::error_code ignored;
  const fs::path folder =
      fs::is_directory(run_path, ignored) ? fs::path(run_path) : fs::path(run_path).parent_path();
  const fs::path file = folder / assessment_file_name;
  if (!fs::exists(file, ignored)) return {};
  const std::string text = read_whole_file(file.string());
  refuse_changed_text(text, file.string());
  return decode_assessment(text, file.string(), run);
}

}  // namespace plumb
