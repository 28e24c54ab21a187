#include "engine/integrate/methods/implicit_stage.h"

#include <algorithm>
#include <limits>

#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

/// Of a new matrix, in corrections with the old one.
constexpr double price = 2.5;
/// Contraction of the corrections above which it pays for itself within a step.
constexpr double slow = 0.15;
/// Contraction above which the old matrix leads astray, and the step begins anew.
constexpr double astray = 1;

}  // namespace

ImplicitStage::ImplicitStage(const MethodSpec& spec, Dynamics& dynamics, double weight)
    : tolerance_(leftover_of_a_step(spec, dynamics, weight)),
      iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))),
      dynamics_(dynamics),
      wear_(price) {}

StepResult ImplicitStage::solve(const StageTerms& stage, const Instant& at, double position,
                                Eigen::VectorXd& x, double leftover) {
  const Cable& cable = dynamics_.cable();
  const double stiffness = stage.force * stage.reach;
  if (factored_mass_ != stage.mass || factored_stiffness_ != stiffness || factored_reach_ != at.reach)
    has_factors_ = false;
  bool renew = !has_factors_ || wear_.is_worn();
  bool old = !renew;  // the matrix is that of an earlier step
  StageTerms terms = stage;
  const auto metres = [&](const StageCorrection& correction) {
    return position * std::max(correction.position, cable.element().length() * correction.slope);
  };
  const double allowed = std::min(tolerance_, leftover);
  x.resize(dynamics_.size());
  double before = 0;  // size of the correction before this one
  for (int i = 0; i < iterations_; ++i) {
    if (renew) {
      if (has_factors_) turn_.lasted(wear_.steps());
      has_factors_ = false;
    }
    const StageCorrection correction =
        dynamics_.correct(terms, renew ? stiffness : 0, next_, at, turn_.turns());
    if (correction.unsound >= 0) {
      best_kernels().add_up(cable.nodes(), terms.point().into(next_));
      has_factors_ = false;
      if (!next_.allFinite())
        return not_converged({std::numeric_limits<double>::infinity(), correction.unsound}, tolerance_,
                             cable.length());
      return {Outcome::singular, "the slope collapsed within Newton's iteration", correction.unsound};
    }
    if (correction.singular >= 0)
      return {Outcome::singular, "Newton's matrix is singular",
              std::min(correction.singular, cable.elements() - 1)};
    x.swap(next_);
    if (renew) {
      has_factors_ = true;
      factored_mass_ = stage.mass;
      factored_stiffness_ = stiffness;
      factored_reach_ = at.reach;
      old = false;
      wear_.renewed();
    }
    if (!correction.finite) break;
    const double size = metres(correction);
    const double rate = before > 0 ? size / before : 1;
    if (size == 0 || left_after(size, before, renew) <= allowed ||
        is_round_off(size, before, cable.length())) {
      wear_.step_took(i + 1);
      return {};
    }
    renew = before > 0 && rate > slow;
    if (old && before > 0 && rate > astray && i + 1 < iterations_) {
      terms.from = stage.from;
      before = 0;
      renew = true;
      continue;
    }
    before = size;
    if (i + 1 < iterations_) terms.from = {1, x.data()};
  }
  has_factors_ = false;
  // What the last correction has changed.
  next_ = x - terms.from.factor * Eigen::Map<const Eigen::VectorXd>(terms.from.numbers, x.size());
  return not_converged(correction_size(next_, position, cable.element().length()), tolerance_,
                       cable.length());
}

}  // namespace plumb
