#include "report/page/conclusion.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/run/mode_table.h"
#include "report/figure/number_markup.h"

namespace plumb {
namespace {

std::string number(double value) {
  return fmt::format("{:.3g}", value);
}

/// "4-element run", "run of chrono".
std::string run_of(const Document& document) {
  if (document.contains("computed_by")) return "run of " + document.at("reported").get<std::string>();
  return fmt::format("{}-element run", document.at("solve").at("elements").get<long>());
}

/// Verdicts of one comparison, the one that uses most of what it is allowed first.
std::vector<Verdict> verdicts_on(const std::string& reference, const std::vector<Verdict>& all) {
  std::vector<Verdict> found;
  for (const Verdict& verdict : all)
    if (verdict.name.starts_with(reference + ": ") && verdict.status != VerdictStatus::not_run &&
        verdict.kind != VerdictKind::regression)
      found.push_back(verdict);
  // A distance that is no number is worse than any.
  const auto share = [](const Verdict& v) {
    const double value = v.value / v.limit;
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Verdict& a, const Verdict& b) { return share(a) > share(b); });
  return found;
}

/// "the published figures", or with the name of the reference where several are of its kind.
std::string what_it_is(const Document& reference, const Document& all) {
  const std::string kind = reference.at("kind").get<std::string>();
  const auto alike =
      std::count_if(all.begin(), all.end(), [&](const Document& other) { return other.at("kind") == kind; });
  const std::string text = kind == "published" ? "the published figures" : "the computed solution";
  return alike > 1 ? fmt::format("{} “{}”", text, reference.at("name").get<std::string>()) : text;
}

/// "up to 0.171 m from the published figures (tip.z, where 0.035 m is allowed)"
std::string distance_of(const Verdict& worst, const std::string& reference, const std::string& what) {
  const std::string column = worst.name.substr(reference.size() + 2);
  if (!std::isfinite(worst.value)) return fmt::format("no finite distance from {} ({})", what, column);
  return fmt::format("{}{} from {} ({}, where {}{} is allowed)", number(worst.value), unit_after(worst.unit),
                     what, column, number(worst.limit), unit_after(worst.unit));
}

std::string sentence_of(const Document& document) {
  const Document& solve = document.at("solve");
  const std::vector<Verdict> verdicts = verdicts_of(document);
  const auto count = [&](VerdictStatus status) {
    return std::count_if(verdicts.begin(), verdicts.end(),
                         [&](const Verdict& v) { return v.status == status; });
  };
  const long failed = count(VerdictStatus::failed), not_run = count(VerdictStatus::not_run),
             others = count(VerdictStatus::another_model), all = std::ssize(verdicts) - others;
  const std::string of_all = counted(all, "criterion", "criteria");
  if (!document.at("complete").get<bool>())
    return fmt::format(
        "The {} failed: it is {}{}, so {}", run_of(document), solve.at("outcome").get<std::string>(),
        document.contains(modes_key)
            ? ""
            : fmt::format(" and ended at {} s of {} s", number(solve.at("end_time").get<double>()),
                          number(document.at("case").at("time").at("end").get<double>())),
        all == 0   ? "it shows nothing of the case."
        : all == 1 ? "its one criterion could not be judged."
                   : fmt::format("none of its {} criteria could be judged.", all));
  if (all == 0 && others == 0)
    return fmt::format("The {} completed and was held against nothing: how accurate it is cannot be told.",
                       run_of(document));

  std::vector<std::string> agreements, distances, differences;
  for (const Document& reference : document.at("references")) {
    const std::string name = reference.at("name").get<std::string>();
    const std::vector<Verdict> own = verdicts_on(name, verdicts);
    if (own.empty()) continue;
    const std::string what = what_it_is(reference, document.at("references"));
    if (reference.contains("model_differences") && own.front().status == VerdictStatus::another_model) {
      differences.push_back(fmt::format("{}{} from {}, which are of another model", number(own.front().value),
                                        unit_after(own.front().unit), what));
      continue;
    }
    const bool met = std::none_of(own.begin(), own.end(),
                                  [](const Verdict& v) { return v.status == VerdictStatus::failed; });
    if (met)
      agreements.push_back(
          fmt::format("with {} to {}{}", what, number(own.front().value), unit_after(own.front().unit)));
    else
      distances.push_back(distance_of(own.front(), name, what));
  }
  std::vector<std::string> parts;
  if (!distances.empty()) parts.push_back("is " + listed(distances));
  if (!agreements.empty()) parts.push_back("agrees " + listed(agreements));
  if (!differences.empty()) parts.push_back("is " + listed(differences));
  std::string text = failed > 0 ? fmt::format("{} of {} not met: the {} ", failed, of_all, run_of(document))
                                : fmt::format("The {} ", run_of(document));
  if (!parts.empty())
    text += listed(parts);
  else
    text += failed > 0 ? "completed" : "completed, and what it was held against is met";
  if (all > 0 && not_run == all)
    text = fmt::format("The {} completed, but none of {} could be judged", run_of(document), of_all);
  else if (not_run > 0)
    text += fmt::format("; {} of {} could not be judged", not_run, of_all);
  return text + ".";
}

}  // namespace

Conclusion conclusion_of(const Document& document, const std::vector<std::string>& clauses) {
  Conclusion conclusion;
  conclusion.good = document.at("all_criteria_met").get<bool>() && !document.at("verdicts").empty();
  conclusion.sentence = sentence_of(document);
  for (std::string clause : clauses) {
    if (clause.empty()) continue;
    if (clause.front() >= 'a' && clause.front() <= 'z') clause.front() += 'A' - 'a';
    conclusion.details += (conclusion.details.empty() ? "" : " ") + clause + ".";
  }
  if (document.at("complete").get<bool>()) return conclusion;
  conclusion.trouble = document.at("solve").at("message").get<std::string>();
  constexpr std::string_view before_help = "; what would help: ";
  if (const std::size_t at = conclusion.trouble.find(before_help); at != conclusion.trouble.npos) {
    conclusion.help = conclusion.trouble.substr(at + before_help.size());
    conclusion.trouble.resize(at);
  }
  return conclusion;
}

}  // namespace plumb
