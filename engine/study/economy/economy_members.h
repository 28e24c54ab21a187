#pragma once

#include "engine/base/codec.h"
#include "engine/study/economy/economy_json.h"
#include "engine/study/economy/economy_study.h"

/// What the journal, study.json and results.json keep of an economy study.
namespace plumb {

/// Without the scene's settings but for its size, which are those of the case.
template <class Archive>
void members(Archive& a, SceneNeed& need) {
  a("name", need.name);
  a("size", need.scene.size);
  a("seconds", need.seconds);
  a("reference_doubt", need.reference_doubt);
  a("certified", need.certified);
  a("economy", need.economy);
}

template <class Archive>
void members(Archive& a, RandomScene& scene) {
  a("number", scene.number);
  a("overrides", scene.overrides);
  a("chosen", scene.chosen);
  a("tolerance", scene.tolerance);
  a("holds", scene.holds);
  a("estimate", scene.estimate);
  a("true_error", scene.true_error);
  a("reference_doubt", scene.reference_doubt);
  a("seconds", scene.seconds);
  a("search_share", scene.search_share);
  a("uncertain", scene.uncertain);
}

}  // namespace plumb
