#include "engine/model/variable_loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/kernels/kernels.h"
#include "engine/model/cross_matrix.h"
#include "engine/model/integration_points.h"
#include "engine/model/quadrature.h"

namespace plumb {
namespace {

using Matrix3 = Eigen::Matrix3d;

/// A vector and its derivative by the direction of the cable.
struct Turned {
  Vec3 value;
  Matrix3 by_direction;
};

/// `value` turned by the shortest rotation from a to b, unit vectors: with w = a × b it is
/// (a·b) v + w × v + w (w·v)/(1 + a·b). Half a turn has no axis of its own: there it is about v, or across
/// it, as a motion in a plane has it that goes on without a break.
Turned turned(const Vec3& value, const Vec3& a, const Vec3& b, bool about_value) {
  constexpr double half_a_turn = 1e-7;
  const Vec3 w = a.cross(b);
  const double c = a.dot(b), sine = w.norm();
  const Matrix3 W = cross_matrix(a);
  Turned result{c * value + w.cross(value),
                value * a.transpose() + a.dot(value) * Matrix3::Identity() - a * value.transpose()};
  if (c < 0 && sine < half_a_turn) {
    if (about_value) result.value += (1 - c) * (value - a.dot(value) * a);
    return result;
  }
  // Beyond a right angle 1 + c would be a difference of like numbers.
  const double reach = c < 0 ? sine * sine / (1 - c) : 1 + c;
  const double share = w.dot(value) / reach;
  result.value += share * w;
  result.by_direction +=
      share * W + (w / reach) * (W.transpose() * value).transpose() - (share / reach) * w * a.transpose();
  return result;
}

/// What a load does where the slope is g: on r and on r'.
struct Action {
  Vec3 on_position = Vec3::Zero(), on_slope = Vec3::Zero();
  Matrix3 position_by_slope = Matrix3::Zero(), slope_by_slope = Matrix3::Zero();
};

Action action(LoadKind kind, const Vec3& value, bool follows, const Vec3& start, const Vec3& g) {
  const double length = g.norm(), square = length * length;
  const Vec3 direction = g / length;
  Turned load{value, Matrix3::Zero()};
  if (follows) {
    load = turned(value, start, direction, kind == LoadKind::moment);
    load.by_direction *= (Matrix3::Identity() - direction * direction.transpose()) / length;
  }
  Action result;
  if (kind != LoadKind::moment) {
    result.on_position = load.value;
    result.position_by_slope = load.by_direction;
    return result;
  }
  const Vec3 across = load.value.cross(g);
  result.on_slope = across / square;
  result.slope_by_slope = (cross_matrix(load.value) - cross_matrix(g) * load.by_direction) / square -
                          (2 / (square * square)) * across * g.transpose();
  return result;
}

}  // namespace

bool is_constant(const LoadSpec& load, const std::map<std::string, double>& parameters) {
  return load.kind != LoadKind::moment && !load.follows &&
         TimeFunction(load.factor, parameters).is_constant();
}

VariableLoads::VariableLoads(const Case& spec) : length_(spec.cable.length), start_(spec.start.direction) {
  for (const LoadSpec& load : spec.loads.applied) {
    if (is_constant(load, spec.parameters) || load.value.isZero(0)) continue;
    Variable variable{load.kind, load.value, load.follows, TimeFunction(load.factor, spec.parameters), 0,
                      0,         {}};
    if (load.kind == LoadKind::distributed) {
      constexpr int points = 5;
      const double l = spec.cable.length / spec.cable.elements;
      variable.last = spec.cable.elements - 1;
      for (const QuadraturePoint& point : gauss_rule(points))
        variable.places.push_back(element_place(spec.cable, point.x, point.weight * l));
    } else {
      const PlaceOnCable on = place_on_cable(spec.cable, load.at);
      variable.first = variable.last = on.element;
      variable.places = {on.place};
    }
    loads_.push_back(std::move(variable));
  }
}

VariableLoads VariableLoads::in_units(const OwnUnits& units) const {
  VariableLoads result = *this;
  result.length_ /= units.length;
  result.time_ *= units.time;
  for (Variable& load : result.loads_) {
    load.value /= load.kind == LoadKind::moment        ? units.moment()
                  : load.kind == LoadKind::distributed ? units.force() / units.length
                                                       : units.force();
    for (ElementPlace& place : load.places) place = place.in_units(units);
  }
  return result;
}

double VariableLoads::size(double duration) const {
  constexpr int times = 256;
  double sum = 0;
  for (const Variable& load : loads_) {
    double greatest = 0;
    for (int k = 0; k <= times; ++k)
      greatest = std::max(greatest, std::abs(load.factor(k * (duration / times) * time_)));
    const double arm = load.kind == LoadKind::moment        ? 1 / length_
                       : load.kind == LoadKind::distributed ? length_
                                                            : 1;
    sum += greatest * arm * load.value.norm();
  }
  return sum;
}

bool VariableLoads::has_tangent() const {
  return std::any_of(loads_.begin(), loads_.end(),
                     [](const Variable& load) { return load.follows || load.kind == LoadKind::moment; });
}

void VariableLoads::add_force(double t, double share, const Eigen::VectorXd& q, Eigen::VectorXd& f) const {
  for (const Variable& load : loads_) {
    const Vec3 value = share * load.factor(t * time_) * load.value;
    for (int e = load.first; e <= load.last; ++e)
      for (const ElementPlace& place : load.places) {
        const Vec3 g = combine(place.slope, q.data() + 6 * e);
        if (!(g.norm() > slope_floor)) continue;
        const Action act = action(load.kind, value, load.follows, start_, g);
        const double weight = load.kind == LoadKind::distributed ? place.length : 1;
        for (std::size_t i = 0; i < 4; ++i)
          f.segment<3>(6 * e + 3 * static_cast<int>(i)) +=
              weight * (place.position[i] * act.on_position + place.slope[i] * act.on_slope);
      }
  }
}

void VariableLoads::add_stiffness(double t, double share, const Eigen::VectorXd& q, double factor,
                                  GeneralBlockTridiagonal<double>& A) const {
  for (const Variable& load : loads_) {
    if (!load.follows && load.kind != LoadKind::moment) continue;
    const Vec3 value = share * load.factor(t * time_) * load.value;
    for (int e = load.first; e <= load.last; ++e)
      for (const ElementPlace& place : load.places) {
        const Vec3 g = combine(place.slope, q.data() + 6 * e);
        if (!(g.norm() > slope_floor)) continue;
        const Action act = action(load.kind, value, load.follows, start_, g);
        const double weight = load.kind == LoadKind::distributed ? place.length : 1;
        Block12 K;
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t j = 0; j < 4; ++j)
            K.block<3, 3>(3 * static_cast<int>(i), 3 * static_cast<int>(j)) =
                (-factor * weight * place.slope[j]) *
                (place.position[i] * act.position_by_slope + place.slope[i] * act.slope_by_slope);
        A.add_element(e, K);
      }
  }
}

}  // namespace plumb
