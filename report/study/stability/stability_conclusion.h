#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/study/stability/stability.h"

namespace plumb {

/// How far a method goes at one value of a map.
struct MethodReach {
  const OutcomeMap* map = nullptr;
  std::size_t at = 0;               ///< place of the value in the map
  double accurate = -1;             ///< greatest setting of its accurate stretch; -1: none
  double accurate_from = -1;        ///< its smallest, where a smaller one was tried; else -1
  double stable = -1;               ///< greatest setting of its stable stretch; -1: none
  double stable_from = -1;          ///< its smallest, where a smaller one was tried; else -1
  double fails = -1;                ///< smallest setting at which it fails; -1: at none
  Outcome then = Outcome::not_run;  ///< how that run ended
};

/// Where in its maps a study is told in short.
struct ToldPlace {
  MapAxis axis = MapAxis::parameter;
  double value = 0;
};

/// The case itself, as far as a map has it, over the parameter or, where none is varied, over the elements.
ToldPlace own_place(const Stability& study);

/// The reach of every method of steps, or of tolerances, that has a map with the place: what bears the
/// greatest setting accurately first, and of those that are alike what stays stable longest.
std::vector<MethodReach> reaches_at(const Stability& study, ToldPlace place, bool by_step);

/// What a reader who has ten seconds needs of a study.
struct StabilityConclusion {
  std::string sentence;  ///< which methods bear the greatest step and stay accurate
  /// Which fail first, how far the critical steps found are from the predicted ones, and which tolerance
  /// methods that choose their steps bear; may be empty.
  std::string details;
};

StabilityConclusion conclude(const Stability& study);

/// The `conclusion` of results.json. Keys as in output/README.md.
nlohmann::ordered_json stability_conclusion_json(const Stability& study);

}  // namespace plumb
