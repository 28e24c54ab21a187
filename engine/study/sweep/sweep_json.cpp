#include "engine/study/sweep/sweep_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/run/case_source_json.h"
#include "engine/run/stored_parts.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no word for what is not finite; null stands for a distance beyond all numbers.
Json number_json(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double number_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Sweep read(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  if (json.at("kind") != "sweep") throw std::runtime_error("it is no sweep");
  if (const int stored = json.at("version"); stored < 1 || stored > sweep_version)
    throw std::runtime_error(
        fmt::format("its version is {}, this program reads up to {}", stored, sweep_version));
  Sweep sweep;
  sweep.loaded = load_case(case_source_from_json(json.at("case")));
  sweep.spec = {json.at("cases"), json.at("seed"), json.at("tolerance"), json.at("time_limit")};
  if (!(sweep.spec.tolerance > 0)) throw std::runtime_error("its tolerance is not greater than 0");
  for (const Json& run : json.at("runs")) sweep.runs.push_back(sweep_run_of(run));
  if (std::ssize(sweep.runs) != sweep.spec.cases)
    throw std::runtime_error(fmt::format("it has {} runs of {} cases", sweep.runs.size(), sweep.spec.cases));
  for (std::size_t k = 0; k < sweep.runs.size(); ++k)
    if (sweep.runs[k].number != static_cast<long>(k))
      throw std::runtime_error(fmt::format("run {} has the number {}", k, sweep.runs[k].number));
  for (const auto& [name, value] : json.at("provenance").items())
    sweep.provenance.emplace_back(one_line(name), one_line(value.get<std::string>()));
  return sweep;
}

}  // namespace

nlohmann::ordered_json sweep_run_json(const SweepRun& run) {
  return {{"number", run.number},
          {"overrides", run.overrides},
          {"method", run.method},
          {"outcome", word(run.outcome)},
          {"message", run.message},
          {"error", number_json(run.error)},
          {"second_error", number_json(run.second_error)},
          {"disagreement", number_json(run.disagreement)},
          {"judged_until", number_json(run.judged_until)},
          {"seconds", number_json(run.seconds)},
          {"finite", run.finite},
          {"fault", run.fault}};
}

SweepRun sweep_run_of(const Json& json) {
  SweepRun run;
  run.number = json.at("number");
  for (const Json& text : json.at("overrides")) run.overrides.push_back(one_line(text));
  run.method = one_line(json.at("method"));
  run.outcome = stored_outcome(json.at("outcome"));
  run.message = one_line(json.at("message"));
  run.error = number_of(json.at("error"));
  run.second_error = number_of(json.at("second_error"));
  run.disagreement = number_of(json.at("disagreement"));
  run.judged_until = number_of(json.at("judged_until"));
  run.seconds = number_of(json.at("seconds"));
  run.finite = json.at("finite");
  run.fault = one_line(json.at("fault"));
  return run;
}

std::string encode_sweep(const Sweep& sweep) {
  Json json{{"kind", "sweep"},
            {"version", sweep_version},
            {"title", sweep.loaded.spec.title},
            {"cases", sweep.spec.cases},
            {"seed", sweep.spec.seed},
            {"tolerance", sweep.spec.tolerance},
            {"time_limit", sweep.spec.time_limit},
            {"case", case_source_to_json(sweep.loaded.source)},
            {"provenance", Json::object()},
            {"runs", Json::array()}};
  for (const auto& [name, value] : sweep.provenance) json["provenance"][name] = value;
  for (const SweepRun& run : sweep.runs) json["runs"].push_back(sweep_run_json(run));
  return to_summed_text(std::move(json), 1);
}

Sweep decode_sweep(const std::string& json, const std::string& file) {
  try {
    return read(json, file);
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
