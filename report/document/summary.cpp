#include <fmt/format.h>

#include "report/base/escape.h"
#include "report/document/document.h"
#include "report/document/given_json.h"
#include "report/document/report_formats.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

/// Bytes of one text among others: what is longer is cut, so that it does not keep the rest out.
constexpr std::size_t longest_text = 4000;

}  // namespace

std::string verdict_table(const std::vector<Verdict>& verdicts, std::size_t room) {
  constexpr std::size_t for_count = 60;
  std::string text = "| verdict | kind | criterion | found |\n| --- | --- | --- | --- |\n";
  std::size_t shown = 0;
  // Failures first: they are what the page is opened for.
  for (const VerdictStatus status : statuses_by_urgency)
    for (const Verdict& verdict : verdicts) {
      if (verdict.status != status) continue;
      const std::string row =
          fmt::format("| {} | {} | {} | {} |\n",
                      status == VerdictStatus::passed ? "passed" : fmt::format("**{}**", word(status)),
                      word(verdict.kind), escape_markdown(verdict.criterion, longest_text),
                      escape_markdown(verdict.message, longest_text));
      if (text.size() + row.size() + for_count > room) {
        room = 0;
        continue;
      }
      text += row;
      ++shown;
    }
  if (shown < verdicts.size())
    text += fmt::format("\n{} more criteria are in results.json.\n", verdicts.size() - shown);
  return text;
}

std::string to_summary(const Document& document) {
  constexpr std::size_t for_the_end = 2 * longest_text;
  const auto text_of = [&](const char* key) {
    return escape_markdown(document.at(key).get<std::string>(), longest_text);
  };
  const Document& solve = document.at("solve");
  std::string text = fmt::format("# {}\n\n{}\n\nOutcome: **{}**, {}.\n\n", text_of("title"),
                                 text_of("headline"), text_of("outcome"), text_of("outcome_reason"));
  text += verdict_table(verdicts_of(document), longest_summary - for_the_end - text.size());
  for (const std::string& distance : distances_in_words(document)) {
    const std::string line = fmt::format("\n{}.\n", escape_markdown(distance, longest_text));
    if (text.size() + line.size() + for_the_end > longest_summary) break;
    text += line;
  }
  if (document.contains("computed_by"))
    return text + fmt::format("\nGiven by {}, {} to {:.4g} s; its {} not known.\n", text_of("computed_by"),
                              counted(solve.at("outputs").get<long>(), "output", "outputs"),
                              solve.at("end_time").get<double>(),
                              document.at("given_runs").at(0).value("seconds", -1.0) > 0
                                  ? "energy is"
                                  : "energy and cost are");
  text += fmt::format(
      "\n{} with {} to {:.4g} s: {}, {} force and {} tangent evaluations, {:.3g} s; energy drift {}.\n",
      escape_markdown(solve.at("method").get<std::string>(), longest_text / 4),
      counted(solve.at("elements").get<long>(), "element", "elements"), solve.at("end_time").get<double>(),
      counted(solve.at("steps").get<long>(), "step", "steps"), solve.at("force_evaluations").get<long>(),
      solve.at("tangent_evaluations").get<long>(), solve.at("solve_seconds").get<double>(),
      escape_markdown(document.at("energy").at("drift_in_words").get<std::string>(), longest_text / 4));
  return text;
}

ReportFormat summary_md_format() {
  return {"summary.md", [](const ReportContent& content) { return content.summary; }};
}

}  // namespace plumb
