#include "engine/study/economy/economy_study_json.h"

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
#include "engine/study/economy/economy_json.h"
#include "engine/study/economy/run_economy.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

std::string line(const Json& json) {
  return one_line(json.get<std::string>());
}

Json need_json(const SceneNeed& need) {
  return {{"name", need.name},           {"size", need.scene.size},
          {"seconds", need.seconds},     {"reference_doubt", need.reference_doubt},
          {"certified", need.certified}, {"economy", economy_json(need.economy)}};
}

SceneNeed need_of(const Json& json, const LoadedCase& loaded) {
  SceneNeed need;
  need.name = line(json.at("name"));
  need.scene = loaded.spec.scene;
  need.scene.size = json.at("size").get<std::array<int, 2>>();
  need.seconds = number(json.at("seconds"));
  need.reference_doubt = number(json.at("reference_doubt"));
  need.certified = json.at("certified");
  need.economy = economy_of(json.at("economy"));
  return need;
}

RandomScene scene_of(const Json& json) {
  RandomScene scene;
  scene.number = json.at("number");
  for (const Json& text : json.at("overrides")) scene.overrides.push_back(line(text));
  scene.chosen = line(json.at("chosen"));
  scene.tolerance = number(json.at("tolerance"));
  scene.holds = json.at("holds");
  scene.estimate = number(json.at("estimate"));
  scene.true_error = number(json.at("true_error"));
  scene.reference_doubt = number(json.at("reference_doubt"));
  scene.seconds = number(json.at("seconds"));
  scene.search_share = number(json.at("search_share"));
  scene.uncertain = line(json.at("uncertain"));
  return scene;
}

EconomyStudy read(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  if (json.at("kind") != economy_kind) throw std::runtime_error("it is no economy study");
  if (const int version = json.at("version"); version != economy_study_version)
    throw std::runtime_error(
        fmt::format("its version is {}, this program reads {}", version, economy_study_version));
  EconomyStudy study;
  study.loaded = load_case(case_source_from_json(json.at("case")));
  study.spec = economy_study_of(study.loaded.spec);
  study.reference = line(json.at("reference"));
  study.safe_seconds = number(json.at("safe_seconds"));
  study.safe_end = number(json.at("safe_end"));
  for (const Json& need : json.at("needs")) study.needs.push_back(need_of(need, study.loaded));
  for (const Json& scene : json.at("scenes")) study.scenes.push_back(scene_of(scene));
  for (const auto& [name, value] : json.at("provenance").items())
    study.provenance.emplace_back(one_line(name), line(value));
  return study;
}

}  // namespace

Json random_scene_json(const RandomScene& scene) {
  return {{"number", scene.number},         {"overrides", scene.overrides},
          {"chosen", scene.chosen},         {"tolerance", scene.tolerance},
          {"holds", scene.holds},           {"estimate", scene.estimate},
          {"true_error", scene.true_error}, {"reference_doubt", scene.reference_doubt},
          {"seconds", scene.seconds},       {"search_share", scene.search_share},
          {"uncertain", scene.uncertain}};
}

std::string encode_economy_study(const EconomyStudy& study) {
  Json json{{"kind", economy_kind},
            {"version", economy_study_version},
            {"title", study.loaded.spec.title},
            {"case", case_source_to_json(study.loaded.source)},
            {"reference", study.reference},
            {"safe_seconds", study.safe_seconds},
            {"safe_end", study.safe_end},
            {"needs", Json::array()},
            {"scenes", Json::array()},
            {"provenance", Json::object()}};
  for (const SceneNeed& need : study.needs) json["needs"].push_back(need_json(need));
  for (const RandomScene& scene : study.scenes) json["scenes"].push_back(random_scene_json(scene));
  for (const auto& [name, value] : study.provenance) json["provenance"][name] = value;
  return to_summed_text(std::move(json), 1);
}

EconomyStudy decode_economy_study(const std::string& json, const std::string& file) {
  try {
    return read(json, file);
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
