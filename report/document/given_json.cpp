#include "report/document/given_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/time_interpolation.h"
#include "report/document/case_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json distance_json(const GivenDistance& distance) {
  return {{"column", distance.column},       {"unit", distance.unit},
          {"points", distance.times.size()}, {"max", distance.max},
          {"max_time", distance.max_time},   {"rms", distance.rms},
          {"in_words", in_words(distance)},  {"coverage", coverage_json(distance.coverage)},
          {"time", distance.times},          {"difference", distance.difference}};
}

/// How fast it was, where that is said.
void add_speed(const GivenRunSpec& spec, Json& json) {
  if (!spec.is_timed()) return;
  json["seconds"] = spec.seconds;
  json["threads"] = spec.threads;
  json["machine"] = spec.machine;
  json["yardstick"] = spec.yardstick;
  json["points"] = Json::array();
  for (const GivenPointSpec& point : spec.points)
    json["points"].push_back({{"label", point.label}, {"file", point.file}, {"seconds", point.seconds}});
}

Json given_run_json(const LoadedCase& loaded, std::size_t k) {
  const GivenRunSpec& spec = loaded.spec.given_runs[k];
  const GivenRun& given = loaded.given_runs[k];
  Json json{{"name", spec.name},
            {"file", spec.file},
            {"program", spec.program},
            {"reported", k == 0 && reports_given_run(loaded.spec)},
            {"outputs", given.times.size()},
            {"first_time", given.times.front()},
            {"last_time", given.times.back()},
            {"interpolated", interpolation_in_words(given.times.size())},
            {"taken_for", given.taken_for},
            {"notes", given.notes},
            {"columns",
             {{"t", {{"file_column", given.time_column}, {"file_unit", given.time_unit}, {"unit", "s"}}}}}};
  add_speed(spec, json);
  for (const GivenColumn& column : given.columns)
    json["columns"][column.name] = {
        {"file_column", column.file_column}, {"file_unit", column.file_unit}, {"unit", column.unit}};
  return json;
}

}  // namespace

Json given_runs_json(const LoadedCase& loaded) {
  Json all = Json::array();
  for (std::size_t k = 0; k < loaded.given_runs.size(); ++k) all.push_back(given_run_json(loaded, k));
  return all;
}

Json given_runs_json(const Results& results) {
  const LoadedCase& loaded = results.run.loaded;
  Json all = given_runs_json(loaded);
  for (std::size_t k = 0; k < loaded.given_runs.size(); ++k) {
    if (all[k]["reported"]) continue;
    const GivenRun& given = loaded.given_runs[k];
    all[k]["probes"]["t"] = {{"unit", "s"}, {"values", given.times}};
    for (const GivenColumn& column : given.columns)
      all[k]["probes"][column.name] = {{"unit", column.unit}, {"values", column.values}};
    all[k]["distances"] = Json::array();
    for (const GivenDistance& distance : results.distances)
      if (distance.given_run == k) all[k]["distances"].push_back(distance_json(distance));
  }
  return all;
}

std::vector<std::string> distances_in_words(const Json& document) {
  std::vector<std::string> result;
  if (!document.contains("given_runs")) return result;
  for (const Json& given : document.at("given_runs")) {
    if (!given.contains("distances")) continue;
    for (const Json& distance : given.at("distances"))
      result.push_back(fmt::format("distance of {} to {}: {} {}", given.at("name").get<std::string>(),
                                   document.at("reported").get<std::string>(),
                                   distance.at("column").get<std::string>(),
                                   distance.at("in_words").get<std::string>()));
  }
  return result;
}

}  // namespace plumb
