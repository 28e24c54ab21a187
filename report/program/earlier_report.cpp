#include "report/program/earlier_report.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/errors.h"
#include "engine/run/rounding_reach.h"
#include "report/diff/picture_moves.h"
#include "report/document/regression.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

/// Throws InputError for a column that is not a list of values with a unit.
void check_columns(const Document& baseline, const std::string& path) {
  for (const auto& [name, column] : baseline.at("probes").items())
    if (!column.is_object() || !column.contains("values") || !column["values"].is_array() ||
        !column.contains("unit") || !column["unit"].is_string())
      throw InputError(path + ": damaged: a column of its probes is no list of values with a unit");
}

/// A results.json that was kept alone, without its pictures, is held to its numbers.
std::vector<PictureMove> moves_since(const Document& baseline, const std::string& path,
                                     const std::vector<Picture>& now) {
  std::error_code ignored;
  const bool whole_folder = fs::is_directory(path, ignored);
  const fs::path folder = whole_folder ? fs::path(path) : fs::absolute(path).parent_path();
  if (!whole_folder && !fs::exists(folder / "figures", ignored)) return {};
  return picture_moves(baseline, folder.string(), now);
}

}  // namespace

Document find_document(const std::string& path, bool may_be_changed) {
  std::error_code ignored;
  return read_document(fs::is_directory(path, ignored) ? (fs::path(path) / "results.json").string() : path,
                       may_be_changed);
}

Document find_baseline(const std::string& path) {
  // One that was changed is told of by a verdict, beside all that it says otherwise.
  Document baseline = find_document(path, true);
  try {
    check_columns(baseline, path);
    // Held against itself it shows whether it has all that is asked of it.
    Document same = baseline;
    hold_against_baseline(same, baseline, path, default_regression_share);
  } catch (const Document::exception&) {
    throw InputError(path + ": damaged: it is not as plumb run writes it");
  }
  return baseline;
}

void hold_against_earlier(Document& document, const Run& run, const Pictures& pictures,
                          const Options& options, const std::string& folder) {
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
  const Document baseline = find_baseline(options.baseline);
  const double share = options.numbers.value_or(default_regression_share);
  ProbeTable reach;
  const std::vector<ProbeMove> moves = probe_moves(baseline, document);
  const bool moved = std::any_of(moves.begin(), moves.end(), [&](const ProbeMove& move) {
    return move.unlike.empty() && !(move.greatest <= share * move.largest);
  });
  if (moved && !reports_given_run(run.loaded.spec) && !rounds_otherwise(baseline, document).empty())
    reach = rounding_reach(run.loaded.spec, run.probes);
  hold_against_baseline(document, baseline, options.baseline, share,
                        moves_since(baseline, options.baseline, pictures.figures), reach);
}

}  // namespace plumb
