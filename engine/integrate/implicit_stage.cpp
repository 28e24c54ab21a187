#include "engine/integrate/implicit_stage.h"

#include <cmath>

#include "engine/integrate/newton.h"

namespace plumb {
namespace {

/// Contraction of the corrections above which a new matrix pays for itself: it costs as much as some two and
/// a half corrections with the old one.
constexpr double slow = 0.15;
/// Contraction above which the old matrix leads astray, and the step begins anew.
constexpr double astray = 1;

}  // namespace

ImplicitStage::ImplicitStage(const MethodSpec& spec, Dynamics& dynamics)
    : tolerance_(spec.parameters.at("newton_tolerance") * dynamics.cable().length()),
      iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))),
      dynamics_(dynamics) {}

StepResult ImplicitStage::solve(const StageEquation& equation, Eigen::VectorXd& x) {
  const Cable& cable = dynamics_.cable();
  const double stiffness = equation.force * equation.reach;
  bool renew = !has_factors_ || factored_mass_ != equation.mass || factored_stiffness_ != stiffness;
  bool old = !renew;  // the matrix is that of an earlier step
  guess_ = x;
  CorrectionSize correction;
  double before = 0;  // size of the correction before this one
  for (int i = 0; i < iterations_; ++i) {
    point_ = equation.base + equation.reach * x;
    dynamics_.force(point_, residual_);
    if (const auto element = dynamics_.take_collapsed()) {
      if (!point_.allFinite()) break;
      return {Outcome::singular, "the slope collapsed within Newton's iteration", *element};
    }
    cable.mass().multiply(x, inertia_);
    if (equation.known != nullptr)
      residual_ = equation.force * residual_ + *equation.known - equation.mass * inertia_;
    else
      residual_ = equation.force * residual_ - equation.mass * inertia_;
    cable.supports().apply(residual_);
    if (renew) {
      has_factors_ = false;
      if (const auto node = dynamics_.factor(point_, equation.mass, stiffness))
        return {Outcome::singular, "Newton's matrix is singular", *node};
      has_factors_ = true;
      factored_mass_ = equation.mass;
      factored_stiffness_ = stiffness;
      old = false;
    }
    dynamics_.solve(residual_);
    ++dynamics_.counters.newton_iterations;
    x += residual_;
    correction = correction_size(residual_, equation.position, cable.element().length());
    if (!std::isfinite(correction.metres)) break;
    if (correction.metres <= tolerance_) return {};
    const double rate = before > 0 ? correction.metres / before : 1;
    if (before > 0 && rate < 1 && correction.metres * rate / (1 - rate) <= tolerance_) return {};
    renew = before > 0 && rate > slow;
    if (old && before > 0 && rate > astray) {
      x = guess_;
      before = 0;
      renew = true;
      continue;
    }
    before = correction.metres;
  }
  has_factors_ = false;
  return not_converged(correction, tolerance_);
}

}  // namespace plumb
