#include "report/study/variants/variants_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/base/escape.h"
#include "report/document/junit_suites.h"
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

}  // namespace

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

VariantsResults evaluate_variants(const VariantsStudy& study, const Stages& stages) {
  VariantsResults results{study, {}, stages};
  for (const VariantResult& variant : study.result.variants)
    if (variant.spec.expects_anything()) results.verdicts.push_back(verdict_of(variant));
  return results;
}

std::string headline(const VariantsResults& results) {
  const std::vector<VariantResult>& variants = results.study.result.variants;
  std::string ends;
  for (const Outcome outcome : outcomes()) {
    const auto count = std::count_if(variants.begin(), variants.end(), [&](const VariantResult& variant) {
      return variant.trajectory.outcome == outcome;
    });
    if (count > 0) ends += fmt::format("{}{} {}", ends.empty() ? "" : ", ", count, word(outcome));
  }
  std::string text = fmt::format("{}: {}. ", counted(std::ssize(variants), "variant", "variants"), ends);
  std::string others;
  for (const Verdict& verdict : results.verdicts)
    if (verdict.status != VerdictStatus::passed)
      others += fmt::format("{}\"{}\"", others.empty() ? "" : ", ", verdict.name);
  if (results.verdicts.empty()) return text + "Nothing is expected of them, so nothing is claimed.";
  if (others.empty())
    return text +
           (results.verdicts.size() == variants.size()
                ? "Each ends as expected, with the figures that are known of it."
                : fmt::format("All {} of which something is expected show it.", results.verdicts.size()));
  return text + fmt::format("Not as expected: {}.", others);
}

std::string to_junit(const VariantsResults& results) {
  JunitSuite suite{std::string(word(VerdictKind::verification)), {}};
  for (const Verdict& verdict : results.verdicts) {
    double seconds = 0;
    for (const VariantResult& variant : results.study.result.variants)
      if (variant.spec.name == verdict.name) seconds = std::max(0.0, variant.trajectory.solve_seconds);
    suite.cases.push_back({verdict.name, verdict.status,
                           fmt::format("expected: {}; found: {}", verdict.criterion, verdict.message),
                           seconds});
  }
  return junit_xml(results.study.result.title, {suite});
}

std::string to_summary(const VariantsResults& results) {
  return fmt::format("# Where it fails: {}\n\n{}\n\n", escape_markdown(results.study.result.title),
                     escape_markdown(headline(results))) +
         verdict_table(results.verdicts);
}

}  // namespace plumb
