#include "engine/study/uncertainty/uncertainty_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/base/json_numbers.h"
#include "engine/read/uncertain_keys.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json part_json(const UncertaintyPart& part, std::size_t greatest) {
  Json json{{"name", part.name}, {"state", word(part.state)}, {"how", part.how}};
  if (part.state == PartState::estimated) {
    json["at_greatest_error"] = number_to_json(part.values[greatest]);
    json["standard_uncertainty"] = numbers_to_json(part.values);
  }
  return json;
}

Json series_json(const SeriesUncertainty& series) {
  Json json{{"reference", series.reference},
            {"series", series.series},
            {"column", series.column},
            {"unit", series.unit},
            {"published", series.published},
            {"error_at_greatest", number_to_json(series.error[series.greatest])},
            {"time_of_greatest", series.times[series.greatest]},
            {"validation_uncertainty_at_greatest", number_to_json(series.validation[series.greatest])},
            {"at_least", !series.whole()},
            {"share_within", series.share_within},
            {"finding", series.finding}};
  json["parts"] = Json::array();
  for (const UncertaintyPart& part : series.parts) json["parts"].push_back(part_json(part, series.greatest));
  json["time"] = series.times;
  json["error"] = numbers_to_json(series.error);
  json["validation_uncertainty"] = numbers_to_json(series.validation);
  return json;
}

Json sampling_json(const InputSampling& sampling) {
  Json json{{"samples", sampling.samples},
            {"seed", sampling.seed},
            {"completed", sampling.completed},
            {"failures", sampling.failures}};
  json["inputs"] = Json::array();
  for (std::size_t k = 0; k < sampling.inputs.size(); ++k) {
    const UncertainInput& input = sampling.inputs[k];
    json["inputs"].push_back({{"key", input.key},
                              {"value", sampling.values[k]},
                              {"distribution", word(input.distribution)},
                              {"spread", input.spread},
                              {"relative", input.relative},
                              {"source", input.source}});
  }
  return json;
}

template <class E>
E from_word(const Json& json, std::initializer_list<E> all) {
  for (const E value : all)
    if (word(value) == json.get<std::string>()) return value;
  throw std::runtime_error(fmt::format("\"{}\" is unknown", json.get<std::string>()));
}

void check_count(const std::vector<double>& values, std::size_t count, const char* what) {
  if (values.size() != count)
    throw std::runtime_error(fmt::format("{} values of {} for {} times", values.size(), what, count));
}

SeriesUncertainty series_from_json(const Json& json) {
  SeriesUncertainty series;
  series.reference = json.at("reference").get<std::string>();
  series.series = json.at("series").get<std::string>();
  series.column = json.at("column").get<std::string>();
  series.unit = json.at("unit").get<std::string>();
  series.published = json.at("published").get<bool>();
  series.times = numbers_from_json(json.at("time"));
  if (series.times.empty()) throw std::runtime_error("a series has no times");
  series.error = numbers_from_json(json.at("error"));
  check_count(series.error, series.times.size(), "the error");
  series.validation = numbers_from_json(json.at("validation_uncertainty"));
  check_count(series.validation, series.times.size(), "the validation uncertainty");
  for (const Json& item : json.at("parts")) {
    UncertaintyPart part;
    part.name = item.at("name").get<std::string>();
    part.state =
        from_word(item.at("state"), {PartState::estimated, PartState::not_estimated, PartState::no_part});
    part.how = item.at("how").get<std::string>();
    if (part.state == PartState::estimated) {
      part.values = numbers_from_json(item.at("standard_uncertainty"));
      check_count(part.values, series.times.size(), "a part");
    }
    series.parts.push_back(std::move(part));
  }
  const auto greatest =
      std::find(series.times.begin(), series.times.end(), json.at("time_of_greatest").get<double>());
  if (greatest == series.times.end())
    throw std::runtime_error("the greatest error is at no time of its series");
  series.greatest = static_cast<std::size_t>(greatest - series.times.begin());
  series.share_within = json.at("share_within").get<double>();
  series.finding = json.at("finding").get<std::string>();
  return series;
}

InputSampling sampling_from_json(const Json& json) {
  InputSampling sampling;
  sampling.samples = json.at("samples").get<int>();
  sampling.seed = json.at("seed").get<long>();
  sampling.completed = json.at("completed").get<int>();
  sampling.failures = json.at("failures").get<std::vector<std::string>>();
  for (const Json& item : json.at("inputs")) {
    sampling.inputs.push_back(
        {item.at("key").get<std::string>(),
         from_word(item.at("distribution"), {Distribution::normal, Distribution::uniform}),
         item.at("spread").get<double>(), item.at("relative").get<bool>(),
         item.at("source").get<std::string>()});
    sampling.values.push_back(item.at("value").get<double>());
  }
  return sampling;
}

}  // namespace

Json uncertainty_json(const Uncertainty& uncertainty) {
  Json json{{"standard", validation_standard},
            {"coverage_factor", coverage_factor},
            {"runs", uncertainty.runs},
            {"seconds", uncertainty.seconds},
            {"sampling", sampling_json(uncertainty.sampling)},
            {"left_out", uncertainty.left_out}};
  json["series"] = Json::array();
  for (const SeriesUncertainty& series : uncertainty.series) json["series"].push_back(series_json(series));
  return json;
}

Uncertainty uncertainty_from_json(const Json& json) {
  Uncertainty uncertainty;
  uncertainty.runs = json.at("runs").get<int>();
  uncertainty.seconds = json.at("seconds").get<double>();
  uncertainty.sampling = sampling_from_json(json.at("sampling"));
  uncertainty.left_out = json.at("left_out").get<std::vector<std::string>>();
  for (const Json& series : json.at("series")) uncertainty.series.push_back(series_from_json(series));
  return uncertainty;
}

}  // namespace plumb
