#include "report/index/comparisons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace plumb {
namespace {

/// What became of a comparison; nullptr where there is no verdict on it.
const Document* verdict_on(const Document& error, const Document& report) {
  const auto text = [&](const char* key) { return error.at(key).get<std::string>(); };
  const std::string run = text("run"), given = run == report.value("reported", "Plumb") ? "" : run + ": ";
  const std::string name = given + text("reference") + ": " +
                           (error.value("against", "printed") == "exact" ? "exact: " : "") + text("column");
  for (const Document& verdict : report.at("verdicts"))
    if (verdict.at("name") == name) return &verdict;
  return nullptr;
}

/// A value, or null for one that is not finite.
Document value_or_null(double value) {
  return std::isfinite(value) ? Document(value) : Document(nullptr);
}

/// The pair at place k of a comparison.
Document pair_at(const Document& error, std::size_t k) {
  const double expected = error.at("expected").at(k).get<double>();
  const Document& difference = error.at("difference").at(k);
  return {
      {"at", error.at("time").at(k)},
      {"reference", expected},
      {"predicted", difference.is_number() ? value_or_null(expected + difference.get<double>()) : nullptr}};
}

/// The place of the greatest |value|; not at the start, where there is more: that is given, not predicted.
std::size_t greatest(const Document& values, const Document& times) {
  std::size_t best = 0;
  double most = -1;
  for (std::size_t k = values.size() > 1 && times.at(0) == 0 ? 1 : 0; k < values.size(); ++k)
    if (values[k].is_number() && std::abs(values[k].get<double>()) > most) {
      most = std::abs(values[k].get<double>());
      best = k;
    }
  return best;
}

struct LogRatios {
  std::vector<double> values;
  double relative_variance = 0;  ///< sum of (u/E)²
  std::size_t left_out = 0;
};

LogRatios log_ratios(const Document& comparisons, const std::string& kind) {
  LogRatios ratios;
  for (const Document& comparison : comparisons) {
    if (comparison.at("kind") != kind) continue;
    const Document &pair = comparison.at("greatest"), &uncertainty = comparison.at("uncertainty");
    if (!has_ratio(pair.at("reference"), pair.at("predicted"))) {
      ++ratios.left_out;
      continue;
    }
    const double reference = pair.at("reference").get<double>();
    ratios.values.push_back(std::log(pair.at("predicted").get<double>() / reference));
    if (uncertainty.is_number())
      ratios.relative_variance += std::pow(uncertainty.get<double>() / std::numbers::sqrt3 / reference, 2);
  }
  return ratios;
}

Document statistics_of_kind(const Document& comparisons, const std::string& kind) {
  const LogRatios ratios = log_ratios(comparisons, kind);
  const auto n = static_cast<double>(ratios.values.size());
  Document result{{"kind", kind},
                  {"comparisons", ratios.values.size() + ratios.left_out},
                  {"left_out", ratios.left_out},
                  {"bias", nullptr},
                  {"spread", nullptr},
                  {"reference_spread", nullptr},
                  {"reference_spread_is_bound", false}};
  if (ratios.values.empty()) return result;
  double mean = 0, variance = 0;
  for (const double value : ratios.values) mean += value / n;
  for (const double value : ratios.values) variance += (value - mean) * (value - mean);
  // Of a single pair nothing is known of how they scatter.
  if (ratios.values.size() < 2) {
    result["bias"] = std::exp(mean);
    return result;
  }
  variance /= n - 1;
  const double stated = ratios.relative_variance / n, of_reference = std::min(stated, variance / 2),
               of_model = variance - of_reference;
  result["bias"] = std::exp(mean + of_model / 2 - of_reference / 2);
  result["spread"] = std::sqrt(of_model);
  result["reference_spread"] = std::sqrt(of_reference);
  result["reference_spread_is_bound"] = stated > variance / 2;
  return result;
}

}  // namespace

bool has_ratio(const Document& reference, const Document& predicted) {
  if (!reference.is_number() || !predicted.is_number()) return false;
  const auto e = reference.get<double>(), m = predicted.get<double>();
  // A quotient that is none is no ratio either: it overflows, or nothing is left of it.
  return std::isfinite(e) && std::isfinite(m) && e != 0 && m / e > 0 && std::isfinite(m / e);
}

Document comparisons_of(const Document& report, const std::string& folder) {
  Document all = Document::array();
  for (const Document& error : report.at("errors")) {
    if (error.at("expected").empty()) continue;
    const Document* verdict = verdict_on(error, report);
    const std::string status = verdict ? verdict->at("status").get<std::string>() : "not run";
    Document one{{"folder", folder},
                 {"name", verdict ? verdict->at("name") : error.at("column")},
                 {"kind", status == "another model" ? Document(status)
                          : verdict                 ? verdict->at("kind")
                                                    : Document("verification")},
                 {"status", status},
                 {"unit", error.at("unit")},
                 {"uncertainty", error.at("reference_uncertainty")}};
    one["greatest"] = pair_at(error, greatest(error.at("expected"), error.at("time")));
    one["farthest"] = pair_at(error, greatest(error.at("difference"), error.at("time")));
    all.push_back(std::move(one));
  }
  return all;
}

Document statistics_of(const Document& comparisons) {
  Document all = Document::array();
  for (const char* kind : {"validation", "verification", "another model"}) {
    Document one = statistics_of_kind(comparisons, kind);
    if (one.at("comparisons") > 0) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace plumb
