#include "report/program/sensitivity_pipeline.h"

#include <filesystem>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/study/sensitivity/sensitivity_json.h"
#include "report/study/sensitivity/sensitivity_results.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* sensitivity_file_name = "sensitivity.json";

}  // namespace

std::optional<Sensitivity> find_sensitivity(const LoadedCase& loaded, Journal& journal, OutputFolder& folder,
                                            Console& console) {
  if (!loaded.spec.sensitivity) return {};
  Runner runner(journal, [&](const std::string& part, double share) { console.progress(part, share); });
  const SensitivityStudy study{loaded, run_sensitivity(loaded, judged_criteria, runner), provenance_now()};
  console.end_progress();
  folder.write(sensitivity_file_name, encode_sensitivity(study));
  return study.result;
}

std::optional<Sensitivity> sensitivity_beside(const std::string& run_path, const LoadedCase& loaded,
                                              OutputFolder& folder) {
  std::error_code ignored;
  const fs::path beside =
      fs::is_directory(run_path, ignored) ? fs::path(run_path) : fs::path(run_path).parent_path();
  const fs::path file = beside / sensitivity_file_name;
  if (!fs::exists(file, ignored)) return {};
  const std::string text = read_whole_file(file.string());
  refuse_changed_text(text, file.string());
  SensitivityStudy study = decode_sensitivity(text, file.string());
  if (study.loaded.source.file.text != loaded.source.file.text ||
      study.loaded.source.overrides != loaded.source.overrides)
    throw InputError(file.string() + ": cannot be used: it is that of another run");
  folder.write(sensitivity_file_name, text);
  return std::move(study.result);
}

}  // namespace plumb
