#include "report/study/sweep/sweep_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/method_info.h"
#include "engine/study/sweep/sweep_cases.h"
#include "engine/study/sweep/sweep_json.h"
#include "report/base/escape.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

using Json = Document;

template <class Which>
long count_of(const Sweep& sweep, Which which) {
  return std::count_if(sweep.runs.begin(), sweep.runs.end(), which);
}

long wrongly_accurate(const Sweep& sweep) {
  return count_of(sweep, [&](const SweepRun& run) { return run.wrongly_accurate(sweep.spec.tolerance); });
}
long faulty(const Sweep& sweep) {
  return count_of(sweep, [](const SweepRun& run) { return !run.fault.empty(); });
}
long not_finite(const Sweep& sweep) {
  return count_of(sweep, [](const SweepRun& run) { return !run.finite; });
}
long unjudged(const Sweep& sweep) {
  return count_of(sweep, [](const SweepRun& run) { return run.fault.empty() && !run.judged(); });
}

/// Of no run at all it says `nothing`.
Verdict none_of(const std::string& name, const std::string& criterion, long found, long of,
                const std::string& reason, const std::string& nothing = "there was no run") {
  Verdict verdict;
  verdict.name = name;
  verdict.criterion = criterion;
  verdict.value = static_cast<double>(found);
  verdict.limit = 0;
  verdict.unit = "runs";
  verdict.status = found == 0 ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = fmt::format("of {}", counted(of, "run", "runs"));
  verdict.message = fmt::format("{} {}", found, verdict.detail);
  verdict.reason = reason;
  if (of > 0) return verdict;
  verdict.status = VerdictStatus::not_run;
  verdict.value = -1;
  verdict.detail = verdict.message = nothing;
  return verdict;
}

/// "none ends accurate beyond it" or "3 end accurate beyond it".
std::string none_or(long found, const std::string& one, const std::string& many) {
  if (found == 0) return "none " + one;
  return fmt::format("{} {}", found, found == 1 ? one : many);
}

std::string quoted(const std::string& text) {
  constexpr std::string_view safe =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!text.empty() && text.find_first_not_of(safe) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

Json counts_json(const OutcomeCounts& counts, const std::vector<Outcome>& shown) {
  long all = 0;
  for (const auto& [outcome, count] : counts) all += count;
  Json json;
  for (const Outcome outcome : shown) {
    const auto found = counts.find(outcome);
    const long count = found == counts.end() ? 0 : found->second;
    json[std::string(word(outcome))] = {{"runs", count},
                                        {"share", static_cast<double>(count) / static_cast<double>(all)}};
  }
  return json;
}

/// Whether the program may be believed where it was not tried, and how far that goes.
void conclude(StudyReport& report, const Sweep& sweep) {
  const long all = std::ssize(sweep.runs), wrong = wrongly_accurate(sweep), faults = faulty(sweep),
             infinite = not_finite(sweep);
  // Runs of one model are not independent of one another.
  const long models = (all + runs_of_a_model - 1) / runs_of_a_model;
  const std::string cases =
      fmt::format("{} of {}", counted(all, "run", "runs"), counted(models, "random model", "random models"));
  if (all == 0) {
    report.headline = "No random case was run, so nothing is claimed.";
  } else if (wrong + faults + infinite == 0) {
    // Of n models that all hold: (1 − p)ⁿ = 5 %.
    const double most = 1 - std::pow(0.05, 1 / static_cast<double>(models));
    report.headline = fmt::format(
        "Every run tells the truth: of {} none ends accurate beyond its tolerance, crashes, hangs or holds a "
        "number that is not finite; with 95 % confidence less than {:.2g} % of such models have one that "
        "does.",
        cases, 100 * most);
  } else {
    report.headline = fmt::format(
        "Not every run tells the truth: of {} {}, {}, {}.", cases,
        none_or(wrong, "ends accurate beyond its tolerance", "end accurate beyond their tolerance"),
        none_or(faults, "crashes or hangs", "crash or hang"),
        none_or(infinite, "holds a number that is not finite", "hold a number that is not finite"));
  }
  if (const long other = unjudged(sweep); other > 0)
    report.details = fmt::format("{} could not be judged.", counted(other, "run", "runs"));
  report.counts = met_in_words(report.verdicts);
}

Json sweep_document(const Sweep& sweep) {
  const std::vector<Outcome> shown = shown_outcomes(sweep);
  Json study{{"cases", sweep.spec.cases},
             {"seed", sweep.spec.seed},
             {"tolerance", sweep.spec.tolerance},
             {"time_limit", sweep.spec.time_limit},
             {"outcomes", counts_json(outcome_counts(sweep), shown)}};
  for (const auto& [method, counts] : outcome_counts_by_method(sweep))
    study["methods"][method] = counts_json(counts, shown);
  study["runs"] = Json::array();
  for (const SweepRun& run : sweep.runs) study["runs"].push_back(sweep_run_json(run));
  return study;
}

}  // namespace

std::vector<Verdict> sweep_verdicts(const Sweep& sweep) {
  const long all = std::ssize(sweep.runs);
  const long accurate = count_of(sweep, [](const SweepRun& run) { return run.outcome == Outcome::accurate; });
  return {none_of("accurate", "no run ends accurate while a second reference puts it beyond its tolerance",
                  wrongly_accurate(sweep), accurate,
                  "The second reference is by an unlike method; what the two references differ by, at most a "
                  "tenth of the tolerance, is allowed beside it.",
                  "no run ended accurate"),
          none_of("faults", "no run crashes, hangs or throws", faulty(sweep), all,
                  "Every model is run in a process of its own."),
          none_of("finite", "no run holds a number that is infinite or none", not_finite(sweep), all, ""),
          none_of("outcomes", "every run ends in one of the seven outcomes", unjudged(sweep), all,
                  "A run that completes is held against a reference.")};
}

OutcomeCounts outcome_counts(const Sweep& sweep) {
  OutcomeCounts counts;
  for (const SweepRun& run : sweep.runs) ++counts[run.outcome];
  return counts;
}

std::vector<std::pair<std::string, OutcomeCounts>> outcome_counts_by_method(const Sweep& sweep) {
  std::vector<std::pair<std::string, OutcomeCounts>> result;
  const auto add = [&](const std::string& method) {
    OutcomeCounts counts;
    for (const SweepRun& run : sweep.runs)
      if (run.method == method) ++counts[run.outcome];
    if (!counts.empty()) result.emplace_back(method, std::move(counts));
  };
  for (const MethodInfo& info : method_infos()) add(info.name);
  return result;
}

std::vector<Outcome> shown_outcomes(const Sweep& sweep) {
  const OutcomeCounts counts = outcome_counts(sweep);
  std::vector<Outcome> shown;
  for (const Outcome outcome : outcomes())
    if (counts.contains(outcome) || (outcome != Outcome::not_run && outcome != Outcome::completed &&
                                     outcome != Outcome::unstable_equilibrium))
      shown.push_back(outcome);
  return shown;
}

std::vector<std::string> outcome_lines(const Sweep& sweep) {
  const OutcomeCounts counts = outcome_counts(sweep);
  std::vector<std::string> lines;
  for (const Outcome outcome : shown_outcomes(sweep)) {
    const auto found = counts.find(outcome);
    const long count = found == counts.end() ? 0 : found->second;
    lines.push_back(fmt::format("  {:<15}{:>8}   {:>7}", word(outcome), count,
                                share_in_words(count, std::ssize(sweep.runs))));
  }
  return lines;
}

std::string share_in_words(long part, long whole) {
  return whole > 0 ? fmt::format("{:.1f} %", 100 * static_cast<double>(part) / static_cast<double>(whole))
                   : "–";
}

std::string trouble_of(const SweepRun& run, double tolerance) {
  if (!run.fault.empty()) return run.fault;
  if (!run.finite) return "holds a number that is not finite";
  if (run.wrongly_accurate(tolerance))
    return fmt::format("accurate with {:.3g} m, but {:.3g} m from the second reference", run.error,
                       run.second_error);
  if (!run.judged()) return fmt::format("ended {}: no two references agree on this model", word(run.outcome));
  return {};
}

std::string command_of(const Sweep& sweep, const SweepRun& run) {
  std::string text = "plumb solve " + quoted(sweep.loaded.source.file.name);
  for (const auto* overrides : {&sweep.loaded.source.overrides, &run.overrides})
    for (const std::string& override_text : *overrides) text += " --set " + quoted(override_text);
  return text;
}

StudyReport evaluate_sweep(const Sweep& sweep, const Stages& stages) {
  StudyReport report{sweep.loaded, "random cases", sweep.provenance, sweep_verdicts(sweep), stages};
  conclude(report, sweep);
  report.results["sweep"] = sweep_document(sweep);
  report.after = "\n| outcome | runs | share |\n| --- | --- | --- |\n";
  const OutcomeCounts counts = outcome_counts(sweep);
  for (const Outcome outcome : shown_outcomes(sweep)) {
    const auto found = counts.find(outcome);
    const long count = found == counts.end() ? 0 : found->second;
    report.after += fmt::format("| {} | {} | {} |\n", word(outcome), count,
                                share_in_words(count, std::ssize(sweep.runs)));
  }
  constexpr std::size_t most_listed = 50;
  std::size_t listed = 0;
  for (const SweepRun& run : sweep.runs) {
    const std::string trouble = trouble_of(run, sweep.spec.tolerance);
    if (trouble.empty() || listed++ >= most_listed) continue;
    report.after += fmt::format("\n- case {}: {}: {}", run.number, escape_markdown(trouble),
                                markdown_code(command_of(sweep, run)));
  }
  if (listed > most_listed) report.after += fmt::format("\n- and {} more", listed - most_listed);
  if (listed > 0) report.after += "\n";
  return report;
}

}  // namespace plumb
