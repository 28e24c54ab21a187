#include "report/study/sensitivity/sensitivity_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "engine/study/sensitivity/sensitivity_members.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

/// Whether it is of another program's run against a reference, which does not change with the case.
bool is_of_other_run(const std::string& name, const Case& spec) {
  for (const GivenRunSpec& given : spec.given_runs)
    for (const ReferenceUse& use : spec.references)
      if (name.starts_with(fmt::format("{}: {}: ", given.name, use.name))) return true;
  return false;
}

std::string percent(double share) {
  return two_digits(100 * share) + " %";
}

/// The change that is the smaller factor; `change` -1: neither is noticed.
struct LeastChange {
  NoticedChange least;
  bool up = true;

  /// What it is of the number.
  double share() const { return up || least.change > 1 ? least.change : least.change / (1 + least.change); }
};

LeastChange least_of(const NumberSensitivity& number, std::size_t k) {
  const NoticedChange &up = number.up.noticed[k], &down = number.down.noticed[k];
  const bool is_up = down.change < 0 || (up.change > 0 && up.change <= down.change);
  return {is_up ? up : down, is_up};
}

/// "6.2 % of density", "density by a factor of 4".
std::string in_words(const LeastChange& of, const std::string& number) {
  const std::string change =
      of.least.change > 1 ? fmt::format("{} by a factor of {}", number, two_digits(1 + of.least.change))
                          : fmt::format("{} of {}", percent(of.share()), number);
  return change + (of.least.by_failure ? " (where the run fails)" : "");
}

Verdict verdict_of(const Sensitivity& found, std::size_t k) {
  const JudgedCriterion& judged = found.criteria[k];
  Verdict verdict;
  verdict.name = judged.name;
  verdict.criterion = fmt::format("{:.3g} {} is not too much to notice anything", judged.limit, judged.unit);
  verdict.unit = "1";
  verdict.limit = 0;
  verdict.reason = "A criterion that lets every mistake pass says nothing where it is met.";
  if (!judged.met || !found.told()) {
    verdict.detail = verdict.message = noticed_in_words(found, k);
    return verdict;
  }
  verdict.detail = verdict.message =
      fmt::format("it notices {} within a factor of two, and {}",
                  counted(found.noticed_numbers(k), "number of the model", "numbers of the model"),
                  counted(found.noticed_blunders(k), "blunder", "blunders"));
  if (const auto failing =
          std::count_if(found.blunders.begin(), found.blunders.end(),
                        [](const BlunderSensitivity& of) { return of.applies() && of.trial.failed(); });
      failing > 0)
    verdict.detail = verdict.message += fmt::format("; {} more would end the run", failing);
  verdict.value = found.weak(k) ? 1 : 0;
  verdict.status = found.weak(k) ? VerdictStatus::failed : VerdictStatus::passed;
  return verdict;
}

/// The change of a number that is noticed first of all, and by which criterion: "0.4 % of length, by known:
/// tip.y"; empty: none is.
std::string sharpest_in_words(const Sensitivity& found) {
  double least = std::numeric_limits<double>::infinity();
  std::string text;
  for (std::size_t k = 0; k < found.criteria.size(); ++k)
    for (const NumberSensitivity& number : found.numbers) {
      if (!found.criteria[k].met || !number.told()) continue;
      const LeastChange of = least_of(number, k);
      if (of.least.change < 0 || of.share() >= least) continue;
      least = of.share();
      text = fmt::format("{}, by {}", in_words(of, number.words), found.criteria[k].name);
    }
  return text;
}

/// The mistakes that no criterion notices, of those that were found out.
std::vector<std::string> unnoticed(const Sensitivity& found) {
  std::vector<std::string> names;
  const auto by_any = [&](const auto& notices) {
    for (std::size_t k = 0; k < found.criteria.size(); ++k)
      if (found.criteria[k].met && notices(k)) return true;
    return false;
  };
  for (const NumberSensitivity& number : found.numbers)
    if (number.told() && !by_any([&](std::size_t k) { return least_of(number, k).least.change >= 0; }))
      names.push_back("any change of " + number.words);
  // A finer mesh is no mistake.
  for (const BlunderSensitivity& of : found.blunders)
    if (of.blunder.kind != Blunder::double_mesh && of.applies() && !of.trial.untold() &&
        !by_any([&](std::size_t k) { return of.trial.notices(k); }))
      names.push_back(of.blunder.name);
  return names;
}

/// What would be noticed, and what not.
void conclude(StudyReport& report, const Sensitivity& found) {
  if (!found.left_out.empty()) {
    report.headline = fmt::format("Nothing was tried: {}.", found.left_out);
    return;
  }
  const auto asked = std::count_if(found.criteria.begin(), found.criteria.end(),
                                   [](const JudgedCriterion& criterion) { return criterion.met; });
  const auto applied = std::count_if(found.blunders.begin(), found.blunders.end(),
                                     [](const BlunderSensitivity& any) { return any.applies(); });
  const std::string weak = weak_in_words(found), sharpest = sharpest_in_words(found);
  const std::vector<std::string> missed = unnoticed(found);
  report.counts =
      fmt::format("{} asked what {} of {} and {}.", counted(asked, "criterion was", "criteria were"),
                  asked == 1 ? "it notices" : "they notice",
                  counted(std::ssize(found.numbers), "number of the model", "numbers of the model"),
                  counted(applied, "blunder", "blunders"));
  if (!found.told() || asked == 0) {
    report.headline = asked == 0 ? "No criterion is met, so what one would notice cannot be told."
                                 : "Nothing was found out: no changed run ended in its time.";
    return;
  }
  report.headline = !weak.empty()    ? weak
                    : missed.empty() ? "Every mistake that was tried would be noticed."
                                     : fmt::format("Mistakes would be noticed, but not {}.", listed(missed));
  if (!sharpest.empty()) report.details = fmt::format("The smallest change that is noticed is {}.", sharpest);
  if (!weak.empty() && !missed.empty())
    report.details += fmt::format("{}None notices {}.", report.details.empty() ? "" : " ", listed(missed));
}

}  // namespace

std::vector<JudgedCriterion> judged_criteria(const Run& run) {
  const Results results = evaluate(run, {});
  const Case& spec = run.loaded.spec;
  std::vector<JudgedCriterion> criteria;
  for (std::size_t k = 0; k < results.verdicts.size(); ++k) {
    const Verdict& verdict = results.verdicts[k];
    if (is_of_other_run(verdict.name, spec)) continue;
    // Figures of another model are not judged.
    if (k < results.errors.size() && !results.errors[k].exact &&
        run.loaded.references[results.errors[k].reference].model)
      continue;
    JudgedCriterion& criterion = criteria.emplace_back(JudgedCriterion{
        verdict.name, verdict.unit, verdict.limit, verdict.value, verdict.status == VerdictStatus::passed});
    if (verdict.status != VerdictStatus::not_run || k >= results.errors.size()) continue;
    // A limit that is too wide beside the cable is not judged; whether the run is within it is told all the
    // same, as a cable that was made shorter must not fail for that.
    const SeriesError& error = results.errors[k];
    const Reference& reference = run.loaded.references[error.reference];
    if (!results.solved() || !error.coverage.enough() || !difference(reference.cable, spec.cable).empty())
      continue;
    criterion.value = spec.references[error.reference].norm == Norm::max ? error.max : error.rms;
    criterion.met = within(criterion.value, criterion.limit);
  }
  return criteria;
}

std::string noticed_in_words(const Sensitivity& found, std::size_t k) {
  const JudgedCriterion& criterion = found.criteria[k];
  const std::string subject = fmt::format("{:.3g} {} on {}", criterion.limit, criterion.unit, criterion.name);
  if (!criterion.met) return subject + " is not met by the case itself: what it notices cannot be told";
  std::vector<std::string> changes, nothing_of, untold, noticed, missed;
  std::multimap<double, std::string> by_change;
  for (const NumberSensitivity& number : found.numbers) {
    const LeastChange of = least_of(number, k);
    if (!number.told())
      untold.push_back(number.words);
    else if (of.least.change < 0)
      nothing_of.push_back(number.words);
    else
      by_change.emplace(of.share(), in_words(of, number.words));
  }
  for (auto& [change, text] : by_change) changes.push_back(std::move(text));
  for (const BlunderSensitivity& of : found.blunders)
    if (of.applies())
      (of.trial.untold() ? untold : of.trial.notices(k) ? noticed : missed).push_back(of.blunder.name);
  if (!nothing_of.empty()) changes.push_back("nothing of " + listed(nothing_of));
  std::string text = subject + " notices " + (changes.empty() ? "no number" : listed(changes));
  if (!noticed.empty()) text += "; of the blunders " + listed(noticed);
  if (!missed.empty()) text += (noticed.empty() ? "; not " : ", but not ") + listed(missed);
  if (!untold.empty())
    text += fmt::format("; not found out within {:g} s a run: {}", found.time_limit, listed(untold));
  return text;
}

std::string weak_in_words(const Sensitivity& found) {
  const std::vector<std::string> names = found.weak_names();
  if (names.empty()) return "";
  return fmt::format("Weak: {} {} nothing.", listed(names), names.size() == 1 ? "notices" : "notice");
}

Document sensitivity_document(const Sensitivity& found) {
  Document json = encode(found, NotFinite::null);
  for (std::size_t k = 0; k < found.criteria.size(); ++k) {
    json["criteria"][k]["weak"] = found.weak(k);
    json["criteria"][k]["in_words"] = noticed_in_words(found, k);
  }
  return json;
}

std::string two_digits(double x) {
  return x < 10 ? fmt::format("{:.2g}", x) : fmt::format("{:.0f}", x);
}

std::string change_text(const Document& noticed, bool up) {
  const double c = noticed.at("change").get<double>();
  if (c < 0) return "nothing";
  return (c > 1 ? fmt::format("{} {}", up ? "×" : "÷", two_digits(1 + c))
          : up  ? "+" + percent(c)
                : "−" + percent(c / (1 + c))) +
         (noticed.at("by_failure").get<bool>() ? " (the run fails)" : "");
}

StudyReport evaluate_sensitivity(const SensitivityStudy& study, const Stages& stages) {
  const Sensitivity& found = study.result;
  StudyReport report{study.loaded, "what the criteria notice", study.provenance, {}, stages};
  report.complete = !found.criteria.empty();
  for (std::size_t k = 0; k < found.criteria.size(); ++k) report.verdicts.push_back(verdict_of(found, k));
  report.suites = suites_of(report.verdicts);
  conclude(report, found);
  report.results["sensitivity"] = sensitivity_document(found);
  return report;
}

}  // namespace plumb
