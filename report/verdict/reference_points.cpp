#include "report/verdict/reference_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "render/scene/view_axes.h"

namespace plumb {
namespace {

constexpr double in_front = 5;          // of all of the cable, in its radii
constexpr double along_an_axis = 1e-9;  // 1 - |cosine| of the angle between

/// What a reference says of one probe's position.
struct PositionSeries {
  std::array<const ReferenceSeries*, 3> components{};

  int known() const {
    return static_cast<int>(std::count_if(components.begin(), components.end(),
                                          [](const ReferenceSeries* series) { return series != nullptr; }));
  }
};

std::map<std::string, PositionSeries> positions_in(const ReferenceUse& use, const Reference& reference,
                                                   const std::vector<ProbeSpec>& probes) {
  std::map<std::string, PositionSeries> positions;
  for (const Comparison& comparison : use.compare)
    for (const ProbeSpec& probe : probes) {
      if (probe.quantity != Quantity::position) continue;
      const std::vector<std::string> columns = column_names(probe);
      for (std::size_t c = 0; c < 3; ++c)
        if (columns[c] == comparison.column)
          positions[probe.name].components[c] = reference.find(comparison.series);
    }
  return positions;
}

std::string known_components(const PositionSeries& position) {
  std::string text;
  for (std::size_t c = 0; c < 3; ++c)
    if (position.components[c] != nullptr) text += fmt::format("{}{}", text.empty() ? "" : " and ", "xyz"[c]);
  return text;
}

}  // namespace

ReferencePoints reference_points(const Run& run, const Trajectory& motion, const SceneInput& scene) {
  ReferencePoints result;
  const ViewAxes axes = view_axes(motion, scene);
  const double front = reach_along(motion, axes.back) + in_front * scene.radius;
  const Case& spec = run.loaded.spec;
  for (std::size_t k = 0; k < spec.references.size(); ++k) {
    const Reference& reference = run.loaded.references[k];
    for (const auto& [probe, position] : positions_in(spec.references[k], reference, spec.probes)) {
      const std::string name = fmt::format("{}, {}", spec.references[k].name, probe);
      const auto missing = static_cast<Eigen::Index>(
          std::find(position.components.begin(), position.components.end(), nullptr) -
          position.components.begin());
      if (position.known() == 1 ||
          (position.known() == 2 && !(axes.parallel && 1 - std::abs(axes.back[missing]) < along_an_axis))) {
        result.left_out.push_back(fmt::format(
            "{}: only its {} {} known{}", name, known_components(position),
            position.known() == 1 ? "is" : "are",
            position.known() == 1
                ? std::string()
                : fmt::format(", which are seen by parallel rays along {} alone", "xyz"[missing])));
        continue;
      }
      ScenePoints points{name, reference.times, {}, {}};
      for (std::size_t i = 0; i < reference.times.size(); ++i) {
        Vec3 place = front * axes.back;
        for (std::size_t c = 0; c < 3; ++c)
          if (position.components[c] != nullptr)
            place[static_cast<Eigen::Index>(c)] = position.components[c]->values[i];
        points.places.push_back(place);
      }
      result.series.push_back(std::move(points));
    }
  }
  return result;
}

}  // namespace plumb
