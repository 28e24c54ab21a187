#include "report/document/regression.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/run/rounding_reach.h"
#include "render/image/image_difference.h"
#include "report/document/case_json.h"

namespace plumb {
namespace {

/// Of a foreign file, in an error of one line.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  const auto within_letter = [&] { return (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U; };
  while (end > 0 && within_letter()) --end;
  return text.substr(0, end) + "…";
}

Verdict move_verdict(const ProbeMove& move, double share) {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.name = "baseline: " + move.column;
  verdict.limit = share;
  verdict.unit = "1";
  verdict.criterion = fmt::format("max |now − baseline| of {} ≤ {:.3g} of its largest", move.column, share);
  verdict.reason = "A run that is repeated must give the same answer, but for rounding.";
  if (!move.unlike.empty()) {
    verdict.status = VerdictStatus::failed;
    verdict.detail = verdict.message = move.unlike;
    return verdict;
  }
  // A column that was 0 throughout has no scale but its own unit.
  verdict.value = move.largest > 0 ? move.greatest / move.largest : move.greatest;
  verdict.status = within(verdict.value, verdict.limit) ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.time = move.time;
  if (move.greatest == 0)
    verdict.detail = "the same to the last digit";
  else if (std::isnan(move.greatest))
    verdict.detail = fmt::format("not a number at {:.4g} s, which is never the same", move.time);
  else
    verdict.detail = fmt::format("moved by {:.3g} {} at {:.4g} s", move.greatest, move.unit, move.time);
  verdict.message = fmt::format("{:.3g} of {:.3g} allowed, {}", verdict.value, share, verdict.detail);
  return verdict;
}

/// A column that moved by more than its share, where the baseline was rounded otherwise; what cannot be
/// compared of it joins `not_compared`.
Verdict move_verdict(const ProbeMove& move, double share, const Document& before, const Document& now,
                     const std::vector<double>& reach, const std::string& what_rounds,
                     std::vector<std::string>& not_compared) {
  constexpr double tells_nothing = 0.01;  // of the largest value
  Verdict verdict = move_verdict(move, share);
  const auto values = [&](const Document& document, const std::string& column) -> const Document& {
    return document.at("probes").at(column).at("values");
  };
  const Document &old_values = values(before, move.column), &new_values = values(now, move.column),
                 &times = values(now, "t");
  const auto number = [](const Document& value) { return value.is_number() ? value.get<double>() : NAN; };
  double worst = -1, allowed = share, horizon = -1;
  for (std::size_t k = 0; k < std::min(reach.size(), times.size()); ++k) {
    if (!(reach[k] <= tells_nothing * move.largest)) {
      horizon = number(times[k]);
      break;
    }
    const double found = std::abs(number(new_values[k]) - number(old_values[k])) / move.largest;
    const double bound = std::max(share, reach[k] / move.largest);
    if (worst >= 0 && !(found / bound > worst / allowed) && !std::isnan(found)) continue;
    worst = found;
    allowed = bound;
    if (std::isnan(found)) break;
  }
  if (horizon >= 0)
    not_compared.push_back(
        fmt::format("{} from {:.4g} s on, where a rounding is all that it tells", move.column, horizon));
  const std::string other = fmt::format("made with another {}", what_rounds);
  if (worst == -1) {
    verdict.status = VerdictStatus::not_run;
    verdict.value = verdict.time = -1;
    verdict.detail = verdict.message = "not comparable here: the baseline was " + other;
    return verdict;
  }
  verdict.value = worst;
  verdict.limit = allowed;
  verdict.status = within(worst, allowed) ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.criterion =
      fmt::format("max |now − baseline| of {} ≤ what {:g} roundings make of it", move.column, roundings);
  verdict.reason = "A baseline of another compiler, processor or system is rounded otherwise.";
  verdict.detail =
      fmt::format("moved by {:.3g} of its largest, where {:.3g} is what another rounding may make; {}", worst,
                  allowed, other);
  if (horizon >= 0) verdict.detail += fmt::format("; not comparable here from {:.4g} s on", horizon);
  verdict.message = verdict.detail;
  return verdict;
}

Verdict picture_verdict(const PictureMove& move) {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.name = "baseline: " + move.file;
  verdict.criterion = move.file + " looks as in the baseline";
  verdict.unit = "1";
  verdict.limit = DifferenceTolerance{}.density;
  verdict.value = move.density;
  verdict.status = move.moved ? VerdictStatus::failed : VerdictStatus::passed;
  verdict.detail = verdict.message = move.in_words;
  verdict.reason = "Pictures of one renderer must be the same; of another, not visibly different.";
  return verdict;
}

/// Of a baseline that was changed after it was written, which vouches for nothing that did not move.
Verdict changed_baseline() {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.status = VerdictStatus::failed;
  verdict.name = "baseline: check sum";
  verdict.criterion = "the baseline is as it was written";
  verdict.value = 1;
  verdict.unit = "1";
  verdict.detail = verdict.message = fmt::format(
      "it was changed after it was written; without its key {0} it is taken as it is", check_sum_key);
  return verdict;
}

Verdict nothing_compared() {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.name = "baseline";
  verdict.criterion = "at least one column or picture is compared";
  verdict.unit = "1";
  verdict.detail = verdict.message =
      "there was nothing to compare: neither report has a probe, and no picture lies beside the earlier one";
  return verdict;
}

/// Whether a criterion allows no more than it did.
bool as_strict(const Verdict& old, const Verdict& now) {
  const auto claims_as_much = [&] {
    return old.coverage && now.coverage && now.coverage->demanded >= old.coverage->demanded &&
           now.coverage->allowance == old.coverage->allowance;
  };
  // The norm stands in the words of the criterion alone, behind the limit where that was tightened.
  const bool same_norm = now.limit < old.limit || now.criterion == old.criterion;
  return now.kind == old.kind && now.unit == old.unit && now.limit <= old.limit && same_norm &&
         (!old.coverage || claims_as_much());
}

/// What passed before passes still, by the same limit; nothing where none passed.
std::optional<Verdict> kept_verdict(const std::vector<Verdict>& before, const std::vector<Verdict>& now) {
  Verdict verdict;
  verdict.kind = VerdictKind::regression;
  verdict.name = "baseline: verdicts";
  verdict.criterion = "verdicts that passed in the baseline and do not pass now, by the same limit = 0";
  verdict.unit = "verdicts";
  verdict.value = 0;
  long passed = 0;
  for (const Verdict& old : before) {
    if (old.status != VerdictStatus::passed || old.kind == VerdictKind::regression) continue;
    ++passed;
    const auto same =
        std::find_if(now.begin(), now.end(), [&](const Verdict& one) { return one.name == old.name; });
    if (same != now.end() && same->status == VerdictStatus::passed && as_strict(old, *same)) continue;
    verdict.value += 1;
    verdict.detail += (verdict.detail.empty() ? "" : ", ") + old.name;
  }
  if (passed == 0) return {};
  verdict.status = verdict.value == 0 ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.message = verdict.value == 0 ? "all that passed then pass now" : "no longer: " + verdict.detail;
  verdict.detail = verdict.message;
  return verdict;
}

}  // namespace

void refuse_other_case(const Document& baseline, const std::string& path, const Document& now) {
  constexpr std::size_t told = 4;
  const Document differences = case_differences(baseline.at("case"), now);
  if (differences.empty()) return;
  std::string text;
  for (std::size_t k = 0; k < std::min(told, differences.size()); ++k) {
    const auto part = [&](const char* key) { return shortened(differences[k].at(key).get<std::string>()); };
    text += fmt::format("{}{} is {} there and {} here", k == 0 ? "" : ", ", part("what"), part("before"),
                        part("now"));
  }
  if (differences.size() > told)
    text += fmt::format(", and {} more",
                        counted(std::ssize(differences) - static_cast<long>(told), "key", "keys"));
  throw InputError(fmt::format("{}: the baseline is of another case: {}", path, text));
}

std::string rounds_otherwise(const Document& baseline, const Document& now) {
  std::string what;
  for (const char* key :
       {"compiler", "flags", "libraries at build", "SUNDIALS at run time", "processor", "system"})
    if (baseline.at("provenance").value(key, "") != now.at("provenance").value(key, ""))
      what += (what.empty() ? "" : ", ") + std::string(key);
  return what;
}

void hold_against_baseline(Document& document, const Document& baseline, const std::string& path,
                           double share, const std::vector<PictureMove>& pictures, const ProbeTable& reach) {
  refuse_other_case(baseline, path, document.at("case"));
  std::vector<Verdict> verdicts;
  std::vector<std::string> not_compared;
  for (const ProbeMove& move : probe_moves(baseline, document)) {
    const auto own = std::find_if(reach.columns.begin(), reach.columns.end(),
                                  [&](const Column& column) { return column.name == move.column; });
    const bool moved =
        move.unlike.empty() && move.largest > 0 && !within(move.greatest / move.largest, share);
    verdicts.push_back(moved && own != reach.columns.end()
                           ? move_verdict(move, share, baseline, document, own->values,
                                          rounds_otherwise(baseline, document), not_compared)
                           : move_verdict(move, share));
  }
  const bool beyond_horizon = !not_compared.empty();
  for (const PictureMove& move : pictures)
    if (beyond_horizon && move.moved)
      not_compared.push_back(move.file + ", which shows what is not comparable");
    else
      verdicts.push_back(picture_verdict(move));
  if (pictures.empty()) not_compared.emplace_back("pictures, none of which lie beside the baseline");
  if (verdicts.empty()) verdicts.push_back(nothing_compared());
  if (sum_in(baseline) == DocumentSum::wrong) verdicts.push_back(changed_baseline());
  if (auto kept = kept_verdict(verdicts_of(baseline), verdicts_of(document)))
    verdicts.insert(verdicts.begin(), std::move(*kept));
  for (const Verdict& verdict : verdicts) document["verdicts"].push_back(verdict_json(verdict));
  document["baseline"] = {{"folder", path},
                          {"made_at", baseline.at("provenance").value("made at", "")},
                          {"not_compared", not_compared},
                          {"changes", changes_between(baseline, document)}};
  const long unmet = std::ssize(verdicts) - count_of(verdicts, VerdictStatus::passed);
  std::string headline = document.at("headline").get<std::string>();
  headline += unmet == 0 ? (not_compared.empty() ? " Nothing moved since the baseline."
                                                 : " Nothing that was compared moved since the baseline.")
                         : fmt::format(" Since the baseline {} of {} criteria of regression are not met.",
                                       unmet, verdicts.size());
  if (!not_compared.empty()) headline += fmt::format(" Not compared: {}.", fmt::join(not_compared, "; "));
  document["headline"] = headline;
  if (unmet > 0) document["all_criteria_met"] = false;
}

}  // namespace plumb
