#include "engine/study/economy/economy_study_json.h"

#include "engine/base/parse_json.h"
#include "engine/study/economy/economy_members.h"
#include "engine/study/economy/run_economy.h"
#include "engine/study/study_record.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// Version 1 had null for all that is not finite, and is no longer read.
constexpr int economy_study_version = 2;

}  // namespace

Json random_scene_json(const RandomScene& scene) {
  return encode(scene, NotFinite::null);
}

std::string encode_economy_study(const EconomyStudy& study) {
  return encode_study_record(economy_kind, economy_study_version, study.loaded.source,
                             {{"title", study.loaded.spec.title},
                              {"reference", study.reference},
                              {"safe_seconds", encode(study.safe_seconds)},
                              {"safe_end", encode(study.safe_end)},
                              {"needs", encode(study.needs)},
                              {"scenes", encode(study.scenes)},
                              {"provenance", encode(study.provenance)}});
}

EconomyStudy decode_economy_study(const std::string& json, const std::string& file) {
  StudyRecord record =
      decode_study_record(json, file, economy_kind, economy_study_version, economy_study_version);
  const Json& body = record.body;
  try {
    EconomyStudy study;
    study.loaded = std::move(record.loaded);
    study.spec = economy_study_of(study.loaded.spec);
    decode(body.at("reference"), study.reference);
    decode(body.at("safe_seconds"), study.safe_seconds);
    decode(body.at("safe_end"), study.safe_end);
    decode(body.at("needs"), study.needs);
    for (SceneNeed& need : study.needs) {
      const auto size = need.scene.size;
      need.scene = study.loaded.spec.scene;
      need.scene.size = size;
    }
    decode(body.at("scenes"), study.scenes);
    decode(body.at("provenance"), study.provenance);
    return study;
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
