#include "report/exports/run_curves.h"

#include <algorithm>
#include <numeric>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "engine/model/cable.h"
#include "engine/run/cable_field.h"

namespace plumb {
namespace {

constexpr CurveField velocity{"velocity", "m/s", 3}, slope{"slope", "1", 3};

/// Fields of one component, by the names that they have in other programs.
struct ScalarField {
  CurveField named;
  ColorField field;
};
constexpr ScalarField scalars[] = {{{"axial_strain", "1"}, ColorField::axial_strain},
                                   {{"axial_force", "N"}, ColorField::axial_force},
                                   {{"curvature", "1/m"}, ColorField::curvature},
                                   {{"bending_moment", "N m"}, ColorField::bending_moment}};

}  // namespace

std::vector<double> places_of_a_curve(int elements) {
  constexpr int most_pieces = 8, enough = 512;
  const int pieces = std::clamp(enough / elements, 1, most_pieces);
  std::vector<double> places;
  for (int k = 0; k <= elements * pieces; ++k) places.push_back(static_cast<double>(k) / pieces);
  return places;
}

RunCurves::RunCurves(const std::vector<ExportedRun>& runs) {
  bool states = true, strains = true;
  for (const auto& [label, run] : runs) {
    auto scene = std::make_unique<SceneOfRun>(run);
    if (scene->motion() == nullptr)
      throw OutputError(label + ": there is nothing to export: " + scene->notes().front());
    const bool has_states = scene->motion() == &run.trajectory;
    const Case& spec = run.loaded.spec;
    states = states && has_states;
    strains = strains && has_states && spec.cable.model != CableModel::rigid;
    Motion motion(*scene->motion());
    std::vector<double> places = places_of_a_curve(motion.elements());
    counts_.push_back(places.size());
    for (std::size_t k = 0; k < motion.output_count(); ++k) times_.push_back(motion.output_time(k));
    curves_.push_back({std::move(scene), motion, has_states ? std::make_shared<const Cable>(spec) : nullptr,
                       std::move(places)});
  }
  std::sort(times_.begin(), times_.end());
  // Times of two runs that differ by their rounding are one.
  constexpr double rounding = 1e-12;
  const double close = rounding * times_.back();
  times_.erase(std::unique(times_.begin(), times_.end(), [&](double a, double b) { return b - a <= close; }),
               times_.end());
  if (states) fields_ = {velocity, slope};
  if (strains)
    for (const ScalarField& scalar : scalars) fields_.push_back(scalar.named);
}

std::size_t RunCurves::points() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

CurveStep RunCurves::at(double time) const {
  CurveStep step;
  step.values.resize(fields_.size());
  for (const Curve& curve : curves_) {
    stop_if_interrupted();
    const Motion& motion = curve.motion;
    const State state = motion.at(time);
    constexpr double rounding = 1e-9;
    step.ended.push_back(time > motion.end() * (1 + rounding) ? 1 : 0);
    const auto add = [](std::vector<double>& to, const Vec3& vector) {
      to.insert(to.end(), vector.begin(), vector.end());
    };
    for (const double place : curve.places) {
      add(step.points, motion.point(state.q, place).position);
      if (fields_.empty()) continue;
      const double s = std::min(place / motion.elements(), 1.0);
      // Rates are interpolated as positions are.
      add(step.values[0], motion.point(state.v, place).position);
      add(step.values[1], curve.cable->at(state.q, s).slope);
      for (std::size_t k = 2; k < fields_.size(); ++k)
        step.values[k].push_back(field_value(*curve.cable, scalars[k - 2].field, state.q, state.v, s));
    }
  }
  return step;
}

}  // namespace plumb
