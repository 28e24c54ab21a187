#include "engine/study/stability/stability_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/parse_json.h"
#include "engine/study/stability/stability_members.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

bool rising(const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]) || (k > 0 && !(values[k] > values[k - 1]))) return false;
  return !values.empty();
}

void check(const Stability& study) {
  for (const OutcomeMap& map : study.maps) {
    const bool whole = rising(map.settings) && rising(map.values) && map.settings.front() > 0 &&
                       map.points.size() == map.settings.size() * map.values.size() &&
                       (map.limits.empty() || map.limits.size() == map.values.size());
    if (!whole) throw std::runtime_error(fmt::format("the map of {} is not whole", map.label));
  }
  for (const EnergyHistory& energy : study.energies)
    if (energy.times.size() != energy.change.size())
      throw std::runtime_error(fmt::format("the energies of {} are not whole", energy.label));
  for (const TrajectoryDivergence& divergence : study.divergences)
    if (divergence.times.size() != divergence.distances.size())
      throw std::runtime_error("the distances of neighbours are not whole");
}

}  // namespace

Json stability_to_json(const Stability& study) {
  return encode(study);
}

Stability stability_from_json(const Json& json) {
  Stability study;
  try {
    decode(json, study);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(json_fault(error));
  }
  check(study);
  return study;
}

}  // namespace plumb
