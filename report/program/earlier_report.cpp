#include "report/program/earlier_report.h"

#include <filesystem>

#include "engine/errors.h"
#include "report/changes.h"
#include "report/regression.h"

namespace plumb {

namespace fs = std::filesystem;

Document find_document(const std::string& path) {
  std::error_code ignored;
  return read_document(fs::is_directory(path, ignored) ? (fs::path(path) / "results.json").string() : path);
}

void hold_against_earlier(Document& document, const Options& options, const std::string& folder) {
  std::error_code ignored;
  if (fs::exists(fs::path(folder) / "results.json", ignored)) {
    try {
      const Document last = find_document(folder);
      document["last_run"] = {{"made_at", last.at("provenance").value("made at", "")},
                              {"changes", changes_between(last, document)}};
    } catch (const InputError&) {
      // One of another version or a damaged one is about to be replaced: nothing can be told of it.
    } catch (const Document::exception&) {
    }
  }
  if (options.baseline.empty()) return;
  try {
    hold_against_baseline(document, find_document(options.baseline), options.baseline,
                          options.numbers.value_or(default_regression_share));
  } catch (const Document::exception& error) {
    throw InputError(options.baseline + ": damaged: " + error.what());
  }
}

}  // namespace plumb
