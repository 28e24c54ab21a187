#include "engine/study/uncertainty/uncertainty_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/base/codec.h"
#include "engine/case/distribution_words.h"
#include "engine/read/uncertain_keys.h"

namespace plumb {

template <class Archive>
void members(Archive& a, UncertaintyPart& part) {
  a("name", part.name);
  a("state", part.state);
  a("how", part.how);
  if (part.has_values()) a("standard_uncertainty", part.values);
}

template <class Archive>
void members(Archive& a, SeriesUncertainty& series) {
  a("reference", series.reference);
  a("series", series.series);
  a("column", series.column);
  a("unit", series.unit);
  a("published", series.published);
  a.said("error_at_greatest", [&] { return series.error[series.greatest]; });
  double time_of_greatest = Archive::reads ? 0 : series.times[series.greatest];
  a("time_of_greatest", time_of_greatest);
  a.said("validation_uncertainty_at_greatest", [&] { return series.validation[series.greatest]; });
  a.said("at_least", [&] { return !series.whole(); });
  a("share_within", series.share_within);
  a("beyond", series.beyond);
  a("finding", series.finding);
  a("shared_model", series.shared_model);
  a("explanation", series.explanation);
  a("parts", series.parts);
  a("time", series.times);
  a("error", series.error);
  a("validation_uncertainty", series.validation);
  if constexpr (Archive::reads)
    series.greatest = static_cast<std::size_t>(
        std::find(series.times.begin(), series.times.end(), time_of_greatest) - series.times.begin());
}

template <class Archive>
void members(Archive& a, SampledInput& sampled) {
  UncertainInput& input = sampled.input;
  a("key", input.key);
  a("value", sampled.value);
  a("distribution", input.distribution);
  a("spread", input.spread);
  a("relative", input.relative);
  a("source", input.source);
}

template <class Archive>
void members(Archive& a, InputSampling& sampling) {
  a("samples", sampling.samples);
  a("seed", sampling.seed);
  a("completed", sampling.completed);
  a("failures", sampling.failures);
  a("inputs", sampling.inputs);
}

template <class Archive>
void members(Archive& a, Uncertainty& uncertainty) {
  a.said("standard", [] { return std::string(validation_standard); });
  a.said("coverage_factor", [] { return coverage_factor; });
  a("runs", uncertainty.runs);
  a("seconds", uncertainty.seconds);
  a("sampling", uncertainty.sampling);
  a("left_out", uncertainty.left_out);
  a("series", uncertainty.series);
}

namespace {

void check_count(const std::vector<double>& values, std::size_t count, const char* what) {
  if (values.size() != count)
    throw std::runtime_error(fmt::format("{} values of {} for {} times", values.size(), what, count));
}

void check(const SeriesUncertainty& series) {
  const std::size_t count = series.times.size();
  if (count == 0) throw std::runtime_error("a series has no times");
  check_count(series.error, count, "the error");
  check_count(series.validation, count, "the validation uncertainty");
  for (const UncertaintyPart& part : series.parts)
    if (part.has_values()) check_count(part.values, count, "a part");
  for (const std::size_t t : series.beyond)
    if (t >= count) throw std::runtime_error("a time beyond the uncertainty is none of its series");
  if (series.greatest == count) throw std::runtime_error("the greatest error is at no time of its series");
}

}  // namespace

nlohmann::ordered_json uncertainty_json(const Uncertainty& uncertainty) {
  nlohmann::ordered_json json = encode(uncertainty, NotFinite::null);
  for (std::size_t k = 0; k < uncertainty.series.size(); ++k) {
    const SeriesUncertainty& series = uncertainty.series[k];
    for (std::size_t p = 0; p < series.parts.size(); ++p)
      if (series.parts[p].has_values())
        json["series"][k]["parts"][p]["at_greatest_error"] =
            encode(series.parts[p].values[series.greatest], NotFinite::null);
  }
  return json;
}

Uncertainty uncertainty_from_json(const nlohmann::ordered_json& json) {
  Uncertainty uncertainty = decoded<Uncertainty>(json, NotFinite::null);
  for (const SeriesUncertainty& series : uncertainty.series) check(series);
  return uncertainty;
}

}  // namespace plumb
