#include "render/scene/drawn_cable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/errors.h"
#include "engine/model/cable.h"
#include "engine/run/cable_field.h"
#include "render/scene/visible_curve.h"

namespace plumb {

namespace {

constexpr double curve_tolerance = 0.25;  // of the drawn centre line, pixels

// Elements between places at which a field is looked at: finely enough for what it does within an element,
// and where there are many of these, for what can be seen.
double field_step(int elements) {
  return std::max(1.0 / 8, elements / 1024.0);
}

}  // namespace

DrawnCable::DrawnCable(const SceneRun& run, double radius, ColorField field)
    : motion_(*run.trajectory, run.offset),
      radius_(radius),
      supports_(run.supports),
      cable_(field == ColorField::none ? nullptr : run.cable),
      field_(cable_ ? field : ColorField::none) {
  if (cable_ && cable_->elements() != motion_.elements())
    throw OutputError("scene: the cable that colours a run has another number of elements");
}

std::vector<CurvePoint> DrawnCable::curve(const State& state, const Camera& camera) const {
  return visible_curve(motion_, state.q, camera, curve_tolerance,
                       cable_ ? field_step(motion_.elements()) : std::numeric_limits<double>::infinity());
}

double DrawnCable::value(const State& state, double place) const {
  return field_value(*cable_, field_, state.q, state.v, std::min(place / motion_.elements(), 1.0));
}

FieldRange DrawnCable::field_range() const {
  FieldRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  if (!cable_) return range;
  constexpr double enough = 500;  // times
  const double step = field_step(motion_.elements());
  const auto outputs = static_cast<double>(motion_.output_count() - 1);
  const double times = std::min(outputs, enough);
  for (double k = 0; k <= times; ++k) {
    const State state = motion_.at(
        motion_.output_time(static_cast<std::size_t>(times > 0 ? std::round(outputs * k / times) : 0)));
    for (double place = 0; place <= motion_.elements(); place += step) {
      range.lo = std::min(range.lo, value(state, place));
      range.hi = std::max(range.hi, value(state, place));
    }
  }
  return range;
}

std::vector<float> DrawnCable::levels(const std::vector<CurvePoint>& curve, const State& state,
                                      FieldRange range) const {
  std::vector<float> levels;
  if (!cable_) return levels;
  for (const CurvePoint& point : curve)
    levels.push_back(static_cast<float>(
        std::clamp((value(state, point.place) - range.lo) / (range.hi - range.lo), 0.0, 1.0)));
  return levels;
}

void DrawnCable::keep_trail(double interval) {
  trail_interval_ = interval;
  const double count = std::min(std::floor(motion_.end() / interval), 1e6);
  for (double k = 0; k <= count; k += 1) tip_path_.push_back(motion_.tip(motion_.state(k * interval)));
}

std::vector<Vec3> DrawnCable::trail(double from, double to, const State& state) const {
  std::vector<Vec3> places;
  const auto count = static_cast<double>(tip_path_.size());
  for (double k = std::max(0.0, std::ceil(from / trail_interval_)); k < count && k * trail_interval_ < to;
       k += 1)
    places.push_back(tip_path_[static_cast<std::size_t>(k)]);
  places.push_back(motion_.tip(state.q));
  return places;
}

}  // namespace plumb
