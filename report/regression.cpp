#include "report/regression.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/case_json.h"
#include "report/changes.h"

namespace plumb {
namespace {

Verdict move_verdict(const ProbeMove& move, double share) {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.name = "baseline: " + move.column;
  verdict.limit = share;
  verdict.unit = "1";
  verdict.criterion = fmt::format("max |now − baseline| of {} ≤ {:.3g} of its largest", move.column, share);
  verdict.reason = "A run that is repeated must give the same answer, but for rounding.";
  if (!move.unlike.empty()) {
    verdict.detail = move.unlike;
    verdict.message = move.unlike;
    return verdict;
  }
  // A column that was 0 throughout has no scale but its own unit.
  verdict.value = move.largest > 0 ? move.greatest / move.largest : move.greatest;
  verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = move.greatest == 0
                       ? "the same to the last digit"
                       : fmt::format("moved by {:.3g} {} at {:.4g} s", move.greatest, move.unit, move.time);
  verdict.message = fmt::format("{:.3g} of {:.3g} allowed, {}", verdict.value, share, verdict.detail);
  return verdict;
}

/// What passed before passes still.
Verdict kept_verdict(const std::vector<Verdict>& before, const std::vector<Verdict>& now) {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.name = "baseline: verdicts";
  verdict.criterion = "verdicts that passed in the baseline and do not pass now = 0";
  verdict.unit = "verdicts";
  verdict.value = 0;
  for (const Verdict& old : before) {
    if (old.status != VerdictStatus::passed || old.kind == VerdictKind::regression) continue;
    const auto same =
        std::find_if(now.begin(), now.end(), [&](const Verdict& one) { return one.name == old.name; });
    if (same != now.end() && same->status == VerdictStatus::passed) continue;
    verdict.value += 1;
    verdict.detail += (verdict.detail.empty() ? "" : ", ") + old.name;
  }
  verdict.status = verdict.value == 0 ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.message = verdict.value == 0 ? "all that passed then pass now" : "no longer: " + verdict.detail;
  verdict.detail = verdict.message;
  return verdict;
}

}  // namespace

void hold_against_baseline(Document& document, const Document& baseline, const std::string& path,
                           double share) {
  std::vector<Verdict> verdicts{kept_verdict(verdicts_of(baseline), verdicts_of(document))};
  for (const ProbeMove& move : probe_moves(baseline, document)) verdicts.push_back(move_verdict(move, share));
  for (const Verdict& verdict : verdicts) document["verdicts"].push_back(verdict_json(verdict));
  document["baseline"] = {{"folder", path},
                          {"made_at", baseline.at("provenance").value("made at", "")},
                          {"changes", changes_between(baseline, document)}};
  const auto moved = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) {
    return verdict.status != VerdictStatus::passed;
  });
  std::string headline = document.at("headline").get<std::string>();
  headline += moved == 0 ? " Nothing moved since the baseline."
                         : fmt::format(" Since the baseline {} of {} criteria of regression are not met.",
                                       moved, verdicts.size());
  document["headline"] = headline;
  if (moved > 0) document["all_criteria_met"] = false;
}

}  // namespace plumb
