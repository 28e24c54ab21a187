#include <fmt/format.h>

#include "report/base/escape.h"
#include "report/document/document.h"
#include "report/document/given_json.h"
#include "report/document/report_formats.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

/// Leaves room below the 64 KiB of a CI page for all else.
constexpr std::size_t size_limit = 60 * 1024;

}  // namespace

std::string verdict_table(const std::vector<Verdict>& verdicts) {
  std::string text = "| verdict | kind | criterion | found |\n| --- | --- | --- | --- |\n";
  std::size_t left_out = 0;
  // Failures first: they are what the page is opened for.
  for (const VerdictStatus status : statuses_by_urgency)
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

std::string to_summary(const Document& document) {
  const auto text_of = [&](const char* key) { return escape_markdown(document.at(key).get<std::string>()); };
  const Document& solve = document.at("solve");
  std::string text = fmt::format("# {}\n\n{}\n\nOutcome: **{}**, {}.\n\n", text_of("title"),
                                 text_of("headline"), text_of("outcome"), text_of("outcome_reason"));
  text += verdict_table(verdicts_of(document));
  for (const std::string& distance : distances_in_words(document))
    if (text.size() < size_limit) text += fmt::format("\n{}.\n", escape_markdown(distance));
  if (document.contains("computed_by"))
    return text + fmt::format("\nGiven by {}, {} to {:.4g} s; its energy and cost are not known.\n",
                              text_of("computed_by"),
                              counted(solve.at("outputs").get<long>(), "output", "outputs"),
                              solve.at("end_time").get<double>());
  text += fmt::format(
      "\n{} with {} to {:.4g} s: {}, {} force and {} tangent evaluations, {:.3g} s; energy drift {}.\n",
      escape_markdown(solve.at("method").get<std::string>()),
      counted(solve.at("elements").get<long>(), "element", "elements"), solve.at("end_time").get<double>(),
      counted(solve.at("steps").get<long>(), "step", "steps"), solve.at("force_evaluations").get<long>(),
      solve.at("tangent_evaluations").get<long>(), solve.at("solve_seconds").get<double>(),
      escape_markdown(document.at("energy").at("drift_in_words").get<std::string>()));
  return text;
}

ReportFormat summary_md_format() {
  return {"summary.md", [](const ReportContent& content) { return content.summary; }};
}

}  // namespace plumb
