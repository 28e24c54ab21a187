#include "report/study/variants/variants_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/run/method_json.h"
#include "report/document/case_json.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

std::string quantity_in_words(const ExpectationSpec& expected) {
  return expected.from.empty() ? expected.quantity
                               : fmt::format("{} from \"{}\"", expected.quantity, expected.from);
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() || unit == "1" ? number : number + " " + unit;
}

/// Places after the decimal point that show a margin to two digits; none for a margin of 10 and more.
int places_for(double within) {
  constexpr int most = 14;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(within))), 0, most);
}

/// Decimals where they are short, else powers of ten.
bool suits_decimals(double value, double within) {
  constexpr double largest = 1e6;
  constexpr int most_places = 12;
  return std::abs(value) < largest && places_for(within) <= most_places;
}

void join(std::string& text, const std::string& more) {
  if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
}

/// The unit of each expectation is known where the variant was run.
std::string expected_figures(const std::vector<ExpectationFound>& figures) {
  std::string text;
  for (const ExpectationFound& figure : figures)
    join(text,
         fmt::format("{} = {}", quantity_in_words(figure.expected),
                     with_unit(with_margin(figure.expected.value, figure.expected.within), figure.unit)));
  return text;
}

Verdict verdict_of(const VariantResult& variant) {
  Verdict verdict;
  verdict.kind = VerdictKind::verification;
  verdict.name = variant.spec.name;
  verdict.criterion = expected_in_words(variant);
  verdict.unit = "1";
  verdict.limit = 1;
  verdict.value = 0;
  for (const ExpectationFound& figure : variant.expectations) {
    const double share = std::abs(figure.found - figure.expected.value) / figure.expected.within;
    if (!(share <= verdict.value) && !std::isnan(verdict.value)) verdict.value = share;
  }
  verdict.status = variant.met() ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = variant.trajectory.message;
  verdict.message = found_in_words(variant);
  if (!variant.trajectory.message.empty())
    verdict.message += fmt::format(" ({})", variant.trajectory.message);
  verdict.reason = variant.spec.reason;
  return verdict;
}

/// How the variants ended.
std::string counts_of(const std::vector<VariantResult>& variants) {
  std::string ends;
  for (const Outcome outcome : outcomes()) {
    const auto count = std::count_if(variants.begin(), variants.end(), [&](const VariantResult& variant) {
      return variant.trajectory.outcome == outcome;
    });
    if (count > 0) ends += fmt::format("{}{} {}", ends.empty() ? "" : ", ", count, word(outcome));
  }
  return fmt::format("{}: {}.", counted(std::ssize(variants), "variant", "variants"), ends);
}

/// What is said where all `expected` variants that something is expected of end so.
std::string as_expected(const std::vector<VariantResult>& variants, std::size_t expected) {
  bool fails = false, holds = false;
  for (const VariantResult& variant : variants)
    if (variant.spec.expects_anything()) (ended_early(variant) ? fails : holds) = true;
  const std::string which = expected == variants.size() ? "" : " with an expectation";
  const std::string all = expected == 1 ? fmt::format("the one variant{}", which)
                                        : fmt::format("all {} variants{}", expected, which);
  const bool one = expected == 1;
  if (!fails) return fmt::format("As expected, {} {} to the end.", all, one ? "runs" : "run");
  return fmt::format("It {} where it should: {} {} as expected.", holds ? "fails and holds" : "fails", all,
                     one ? "ends" : "end");
}

/// Whether they end as expected, and how close it is.
void conclude(StudyReport& report, const std::vector<VariantResult>& variants) {
  const std::vector<Verdict>& verdicts = report.verdicts;
  report.counts = counts_of(variants);
  std::vector<std::string> others;
  const Verdict* closest = nullptr;
  for (const Verdict& verdict : verdicts) {
    if (verdict.status != VerdictStatus::passed) others.push_back(fmt::format("\"{}\"", verdict.name));
    if (!closest || verdict.value > closest->value) closest = &verdict;
  }
  if (verdicts.empty()) {
    report.headline = "Nothing is expected of the variants, so nothing is claimed.";
  } else if (!others.empty()) {
    report.headline = fmt::format("Not as expected: {} of {}: {}.", others.size(),
                                  counted(std::ssize(verdicts), "variant", "variants"), listed(others));
    const auto first = std::find_if(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) {
      return verdict.status != VerdictStatus::passed;
    });
    report.details =
        fmt::format("{} was expected to be {}, and is {}.", others.front(), first->criterion, first->message);
  } else {
    report.headline = as_expected(variants, verdicts.size());
    if (closest->value > 0)
      report.details = fmt::format(
          "Every figure known of them is met; the closest, of \"{}\", uses {:.2g} % of its margin.",
          closest->name, 100 * closest->value);
  }
}

Document figure_json(const ExpectationFound& figure) {
  Document json{{"quantity", figure.expected.quantity},
                {"expected", figure.expected.value},
                {"within", figure.expected.within},
                {"found", figure.found},
                {"unit", figure.unit},
                {"met", figure.met()},
                {"source", figure.expected.source}};
  if (!figure.expected.from.empty()) json["from"] = figure.expected.from;
  return json;
}

Document variant_json(const VariantResult& variant) {
  Run run;
  run.loaded.spec = variant.run;
  run.trajectory = variant.trajectory;
  Document json{{"name", variant.spec.name},
                {"overrides", variant.spec.overrides},
                {"method", method_json(variant.run.method)},
                {"expected_outcome", variant.spec.outcome},
                {"expected_message", variant.spec.says},
                {"outcome_met", variant.outcome_met()},
                {"met", variant.met()},
                {"reason", variant.spec.reason},
                {"solve", solve_json(run)},
                {"figures", Document::array()}};
  for (const ExpectationFound& figure : variant.expectations) json["figures"].push_back(figure_json(figure));
  return json;
}

}  // namespace

bool ended_early(const VariantResult& variant) {
  return variant.trajectory.outcome != Outcome::completed;
}

std::string with_margin(double value, double within) {
  return fmt::format("{} ± {:.2g}", to_margin(value, within), within);
}

std::string to_margin(double value, double within) {
  if (!std::isfinite(value)) return "none";
  if (std::abs(value) < within) return fmt::format("{:.2g}", value);
  if (suits_decimals(value, within)) return fmt::format("{:.{}f}", value, places_for(within));
  const int digits = std::clamp(static_cast<int>(std::log10(std::abs(value) / within)) + 2, 2, 15);
  return fmt::format("{:.{}e}", value, digits - 1);
}

std::string expected_in_words(const VariantResult& variant) {
  std::string text = variant.spec.outcome;
  if (!variant.spec.says.empty()) join(text, fmt::format("says \"{}\"", variant.spec.says));
  join(text, expected_figures(variant.expectations));
  return text;
}

std::string found_in_words(const VariantResult& variant) {
  std::string text(word(variant.trajectory.outcome));
  for (const ExpectationFound& figure : variant.expectations)
    join(text, fmt::format("{} = {}", quantity_in_words(figure.expected),
                           with_unit(to_margin(figure.found, figure.expected.within), figure.unit)));
  return text;
}

StudyReport evaluate_variants(const VariantsStudy& study, const Stages& stages) {
  const std::vector<VariantResult>& variants = study.result.variants;
  const bool any_early = std::any_of(variants.begin(), variants.end(), ended_early);
  StudyReport report{
      study.loaded, any_early ? "where it fails" : "variants compared", study.result.provenance, {}, stages};
  JunitSuite suite{std::string(word(VerdictKind::verification)), {}};
  Document& all = report.results["variants"] = Document::array();
  for (const VariantResult& variant : variants) {
    all.push_back(variant_json(variant));
    if (!variant.spec.expects_anything()) continue;
    const Verdict& verdict = report.verdicts.emplace_back(verdict_of(variant));
    suite.cases.push_back({verdict.name, verdict.status,
                           fmt::format("expected: {}; found: {}", verdict.criterion, verdict.message),
                           std::max(0.0, variant.trajectory.solve_seconds)});
  }
  conclude(report, variants);
  report.suites = {suite};
  return report;
}

}  // namespace plumb
