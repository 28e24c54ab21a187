#include "engine/integrate/methods/rigid_rod.h"

#include <Eigen/Core>
#include <stdexcept>

#include "engine/integrate/methods/one_step_method.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

/// Direction of the rod, and its rate, 1/s.
struct Rod {
  Vec3 d;
  Vec3 w;
};

class RigidRod : public OneStepMethod {
 public:
  RigidRod(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 4, dynamics, start),
        nodes_(dynamics.cable().nodes()),
        element_length_(dynamics.cable().element().length()) {
    const Cable& cable = dynamics.cable();
    const double length = cable.length();
    inertia_ = cable.constants().mass_per_length * length * length * length / 3;
    for (const PointMass& point : cable.mass().points()) {
      const double from = element_length_ * point.element;
      const double along = (point.shape[0] + point.shape[2]) * from + point.shape[1] +
                           point.shape[2] * element_length_ + point.shape[3];
      inertia_ += point.mass * along * along;
    }
    pull_ = pull_of(cable.external_force());
  }

  void interpolate(double t, State& at) const override {
    OneStepMethod::interpolate(t, at);
    write(whole(rod_of(at)), at);
  }

 private:
  StepResult advance(double h, const State& from, State& to) override {
    const Rod start = rod_of(from);
    const Vec3 k1 = rate(from.t, start);
    const Rod second{start.d + h / 2 * start.w, start.w + h / 2 * k1};
    const Vec3 k2 = rate(from.t + h / 2, second);
    const Rod third{start.d + h / 2 * second.w, start.w + h / 2 * k2};
    const Vec3 k3 = rate(from.t + h / 2, third);
    const Rod fourth{start.d + h * third.w, start.w + h * k3};
    const Vec3 k4 = rate(from.t + h, fourth);
    dynamics().counters.force_evaluations += 4;
    write(whole({start.d + h / 6 * (start.w + 2 * (second.w + third.w) + fourth.w),
                 start.w + h / 6 * (k1 + 2 * (k2 + k3) + k4)}),
          to);
    return {};
  }

  /// Q/(m L³/3) of forces on the nodes.
  Vec3 pull_of(const Eigen::VectorXd& force) const {
    Vec3 work = Vec3::Zero();
    for (int node = 0; node < nodes_; ++node)
      work += element_length_ * node * force.segment<3>(6 * node) + force.segment<3>(6 * node + 3);
    return work / inertia_;
  }

  Vec3 rate(double t, const Rod& rod) {
    Vec3 pull = pull_;
    if (const Cable& cable = dynamics().cable(); !cable.conservative()) {
      scratch_.q.resize(6 * nodes_);
      scratch_.v.resize(6 * nodes_);
      write(rod, scratch_);
      force_.setZero(6 * nodes_);
      cable.add_other_forces(t, 1, scratch_.q, scratch_.v, force_);
      pull += pull_of(force_);
    }
    return pull - (pull.dot(rod.d) + rod.w.squaredNorm()) * rod.d;
  }

  static Rod whole(const Rod& rod) {
    const Vec3 d = rod.d.normalized();
    return {d, rod.w - rod.w.dot(d) * d};
  }

  static Rod rod_of(const State& state) { return {state.q.segment<3>(3), state.v.segment<3>(3)}; }

  void write(const Rod& rod, State& to) const {
    for (int node = 0; node < nodes_; ++node) {
      to.q.segment<3>(6 * node) = element_length_ * node * rod.d;
      to.q.segment<3>(6 * node + 3) = rod.d;
      to.v.segment<3>(6 * node) = element_length_ * node * rod.w;
      to.v.segment<3>(6 * node + 3) = rod.w;
    }
  }

  int nodes_;
  double element_length_;
  double inertia_;  // kg m²
  Vec3 pull_;       // a of the constant loads, 1/s²
  State scratch_;
  Eigen::VectorXd force_;
};

}  // namespace

std::unique_ptr<Method> make_rigid_rod(const MethodSpec& spec, Dynamics& dynamics, const State& start) {
  if (!spec.step) throw std::invalid_argument("a rigid rod is integrated with a fixed step");
  return std::make_unique<RigidRod>(spec, dynamics, start);
}

}  // namespace plumb
