#include <fmt/format.h>

#include "report/escape.h"
#include "report/results.h"

namespace plumb {
namespace {

/// Leaves room below the 64 KiB of a CI page for all else.
constexpr std::size_t size_limit = 60 * 1024;

}  // namespace

std::string verdict_table(const std::vector<Verdict>& verdicts) {
  std::string text = "| verdict | kind | criterion | found |\n| --- | --- | --- | --- |\n";
  std::size_t left_out = 0;
  // Failures first: they are what the page is opened for.
  for (const VerdictStatus status : {VerdictStatus::failed, VerdictStatus::not_run, VerdictStatus::passed})
    for (const Verdict& verdict : verdicts) {
      if (verdict.status != status) continue;
      const std::string row = fmt::format(
          "| {} | {} | {} | {} |\n",
          status == VerdictStatus::passed ? "passed" : fmt::format("**{}**", word(status)),
          word(verdict.kind), escape_markdown(verdict.criterion), escape_markdown(verdict.message));
      if (text.size() + row.size() > size_limit)
        ++left_out;
      else
        text += row;
    }
  if (left_out > 0) text += fmt::format("\n{} more criteria are in results.json.\n", left_out);
  return text;
}

std::string to_summary(const Results& results) {
  const Run& run = results.run;
  const Trajectory& t = run.trajectory;
  std::string text = fmt::format("# {}\n\n{}\n\nOutcome: **{}**, {}.\n\n",
                                 escape_markdown(run.loaded.spec.title), escape_markdown(headline(results)),
                                 word(results.outcome), escape_markdown(outcome_reason(results)));
  text += verdict_table(results.verdicts);
  for (const GivenDistance& distance : results.distances) {
    if (text.size() > size_limit) break;
    text += fmt::format("\nDistance of {} to {}: {} {}.\n",
                        escape_markdown(run.loaded.spec.given_runs[distance.given_run].name),
                        escape_markdown(reported_name(run.loaded.spec)), escape_markdown(distance.column),
                        in_words(distance));
  }
  if (reports_given_run(run.loaded.spec)) {
    text += fmt::format("\nGiven by {}, {} from {:.4g} to {:.4g} s; energy and cost are not known.\n",
                        escape_markdown(computed_by(run.loaded.spec.given_runs.front())),
                        counted(std::ssize(t.times), "output", "outputs"), t.times.front(), t.times.back());
    return text;
  }
  text += fmt::format(
      "\n{} with {} to {:.4g} s: {}, {} force and {} tangent evaluations, {:.3g} s; energy drift {}.\n",
      escape_markdown(run.loaded.spec.method.name), counted(t.elements, "element", "elements"), t.end_time,
      counted(t.counters.steps, "step", "steps"), t.counters.force_evaluations,
      t.counters.tangent_evaluations, t.solve_seconds, drift_in_words(t));
  return text;
}

}  // namespace plumb
