#include "engine/run/centerline_from_probes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/time_interpolation.h"
#include "engine/model/hermite.h"
#include "engine/model/supports.h"

namespace plumb {
namespace {

constexpr int drawn_elements = 64;   // of the curve that is drawn
constexpr double farthest = 1000;    // cable lengths, beyond which a picture shows nothing
constexpr double same_place = 1e-9;  // of the length

using Components = std::array<const GivenColumn*, 3>;

/// A place of the cable that is known over time.
struct Place {
  double at = 0;  ///< fraction of the length
  std::string name;
  std::optional<Components> position;  ///< nothing: held at the origin
  std::optional<Components> slope;
};

std::optional<Components> components(const GivenRun& given, const ProbeSpec& probe) {
  Components found{};
  const std::vector<std::string> names = column_names(probe);
  for (std::size_t k = 0; k < 3; ++k) {
    found[k] = given.find(names[k]);
    if (found[k] == nullptr) return {};
  }
  return found;
}

std::vector<Place> known_places(const Case& spec, const GivenRun& given) {
  std::vector<Place> places;
  const auto near = [](double at) {
    return [at](const Place& p) { return std::abs(p.at - at) < same_place; };
  };
  for (const ProbeSpec& probe : spec.probes) {
    if (probe.quantity != Quantity::position) continue;
    const auto position = components(given, probe);
    if (position && std::none_of(places.begin(), places.end(), near(probe.at)))
      places.push_back({probe.at, probe.name, position, {}});
  }
  if (hold_of(spec.supports.first).position && std::none_of(places.begin(), places.end(), near(0)))
    places.push_back({0, "the held first end", {}, {}});
  for (const ProbeSpec& probe : spec.probes) {
    const auto place = std::find_if(places.begin(), places.end(), near(probe.at));
    if (probe.quantity == Quantity::slope && place != places.end()) place->slope = components(given, probe);
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.at < b.at; });
  return places;
}

/// The interval of the places that s is in.
std::size_t interval(const std::vector<Place>& places, double s) {
  std::size_t k = 0;
  while (k + 2 < places.size() && s > places[k + 1].at) ++k;
  return k;
}

/// Positions and slopes at the nodes of the drawn curve as linear functions of what is known: a row a node, a
/// column a known position, and behind them one a known slope.
struct Shape {
  Eigen::MatrixXd positions, slopes;
};

Shape hermite_shape(const std::vector<Place>& places, double length, const std::vector<double>& nodes) {
  const auto count = static_cast<Eigen::Index>(places.size()), rows = static_cast<Eigen::Index>(nodes.size());
  Shape shape{Eigen::MatrixXd::Zero(rows, 2 * count), Eigen::MatrixXd::Zero(rows, 2 * count)};
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double s = nodes[static_cast<std::size_t>(row)];
    const std::size_t k = interval(places, s);
    const double l = (places[k + 1].at - places[k].at) * length;
    const double x = (s - places[k].at) * length / l;
    const auto value = Hermite::values(x, l), slope = Hermite::slopes(x, l);
    const auto i = static_cast<Eigen::Index>(k);
    const std::array<Eigen::Index, 4> columns{i, count + i, i + 1, count + i + 1};
    for (std::size_t c = 0; c < 4; ++c) {
      shape.positions(row, columns[c]) = value[c];
      shape.slopes(row, columns[c]) = slope[c];
    }
  }
  return shape;
}

/// Slopes of the natural cubic spline at the places: a matrix that the known positions are multiplied by.
Eigen::MatrixXd spline_slopes(const std::vector<Place>& places, double length) {
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(count, count), right = left;
  const auto inverse = [&](Eigen::Index k) {
    return 1 /
           ((places[static_cast<std::size_t>(k) + 1].at - places[static_cast<std::size_t>(k)].at) * length);
  };
  for (Eigen::Index k = 0; k + 1 < count; ++k) {
    // Continuity of the second derivative at the inner places, and none at the outer ones.
    const double h = inverse(k);
    for (const Eigen::Index row : {k, k + 1}) {
      left(row, row) += 2 * h;
      left(row, row == k ? k + 1 : k) += h;
      right(row, k) -= 3 * h * h;
      right(row, k + 1) += 3 * h * h;
    }
  }
  return left.partialPivLu().solve(right);
}

Shape spline_shape(const std::vector<Place>& places, double length, const std::vector<double>& nodes) {
  const auto count = static_cast<Eigen::Index>(places.size());
  const Eigen::MatrixXd slopes = spline_slopes(places, length);
  const Shape hermite = hermite_shape(places, length, nodes);
  return {hermite.positions.leftCols(count) + hermite.positions.rightCols(count) * slopes,
          hermite.slopes.leftCols(count) + hermite.slopes.rightCols(count) * slopes};
}

/// What is known at a time, a row a place (and then a row a slope): values, or rates.
Eigen::MatrixXd known(const std::vector<Place>& places, bool with_slopes, const std::vector<double>& times,
                      double t, double (TimeInterpolation::*what)(double) const) {
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(with_slopes ? 2 * count : count, 3);
  const auto fill = [&](Eigen::Index row, const std::optional<Components>& from) {
    if (!from) return;
    for (std::size_t k = 0; k < 3; ++k)
      result(row, static_cast<Eigen::Index>(k)) = (TimeInterpolation(times, (*from)[k]->values).*what)(t);
  };
  for (Eigen::Index row = 0; row < count; ++row) {
    const Place& place = places[static_cast<std::size_t>(row)];
    fill(row, place.position);
    if (with_slopes) fill(count + row, place.slope);
  }
  return result;
}

Eigen::VectorXd coordinates(const Shape& shape, const Eigen::MatrixXd& of) {
  const Eigen::MatrixXd positions = shape.positions * of, slopes = shape.slopes * of;
  Eigen::VectorXd q(6 * positions.rows());
  for (Eigen::Index node = 0; node < positions.rows(); ++node)
    q.segment<6>(6 * node) << positions.row(node).transpose(), slopes.row(node).transpose();
  return q;
}

std::vector<double> frame_times(const GivenRun& given, double end, double frame_rate) {
  const double first = std::max(0.0, given.times.front()), last = std::min(given.times.back(), end);
  std::vector<double> times;
  for (long k = 0; first + static_cast<double>(k) / frame_rate < last; ++k)
    times.push_back(first + static_cast<double>(k) / frame_rate);
  if (last >= first) times.push_back(last);
  return times;
}

bool can_be_seen(const std::vector<Place>& places, double length) {
  for (const Place& place : places)
    if (place.position)
      for (const GivenColumn* column : *place.position)
        for (const double x : column->values)
          if (std::abs(x) > farthest * length) return false;
  return true;
}

}  // namespace

DrawnCurve curve_through_probes(const Case& spec, const GivenRun& given, const std::string& name,
                                double frame_rate) {
  const std::vector<Place> places = known_places(spec, given);
  std::vector<std::string> names;
  for (const Place& place : places) names.push_back(place.name);
  if (places.size() < 2)
    return {
        {},
        fmt::format("{} gives positions, with their three components, at {}: two places are needed to draw "
                    "the cable",
                    name, places.empty() ? "no place" : "one place only, " + names.front())};
  const double length = spec.cable.length;
  if (!can_be_seen(places, length))
    return {{}, fmt::format("positions of {} are more than {:g} lengths of the cable away", name, farthest)};
  const std::vector<double> times = frame_times(given, spec.time.end, frame_rate);
  if (times.empty()) return {{}, fmt::format("{} has no time from 0 to {:.4g} s", name, spec.time.end)};

  const bool with_slopes =
      std::all_of(places.begin(), places.end(), [](const Place& place) { return place.slope.has_value(); });
  Trajectory motion;
  motion.outcome = Outcome::completed;
  motion.elements = drawn_elements;
  const double from = places.front().at, to = places.back().at;
  motion.element_length = (to - from) * length / drawn_elements;
  std::vector<double> nodes;
  for (int k = 0; k <= drawn_elements; ++k) nodes.push_back(from + (to - from) * k / drawn_elements);
  const Shape shape =
      with_slopes ? hermite_shape(places, length, nodes) : spline_shape(places, length, nodes);
  for (const double t : times) {
    motion.times.push_back(t);
    motion.q.push_back(
        coordinates(shape, known(places, with_slopes, given.times, t, &TimeInterpolation::value)));
    motion.v.push_back(
        coordinates(shape, known(places, with_slopes, given.times, t, &TimeInterpolation::rate)));
  }
  motion.end_time = times.back();
  return {
      std::move(motion),
      with_slopes
          ? fmt::format(
                "The curve of {} is that of the positions and slopes which it gives at {} places ({})", name,
                places.size(), fmt::join(names, ", "))
          : fmt::format("The curve of {} is drawn through {} places ({}){}; the run tells nothing of what is "
                        "between them",
                        name, places.size(), fmt::join(names, ", "),
                        places.size() > 2 ? ", as a natural cubic spline" : ", as a straight line")};
}

}  // namespace plumb
