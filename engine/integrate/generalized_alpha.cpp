#include <fmt/format.h>

#include <cmath>

#include "engine/integrate/fixed_step_method.h"
#include "engine/integrate/newton.h"

namespace plumb {
namespace {

/// The generalized-α method of Chung and Hulbert (1993), with the nonlinear forces at the generalized
/// midpoint (Kuhl and Crisfield 1999):
///   M ((1 − αm) aₙ₊₁ + αm aₙ) = f((1 − αf) qₙ₊₁ + αf qₙ),
///   qₙ₊₁ = qₙ + h vₙ + h² ((½ − β) aₙ + β aₙ₊₁),   vₙ₊₁ = vₙ + h ((1 − γ) aₙ + γ aₙ₊₁),
/// with αm, αf, β and γ from the spectral radius ρ∞ at infinite frequency. Order 2, provided that it starts
/// from the true acceleration; ρ∞ = 1 is the midpoint rule, which keeps every linear oscillation, 0 removes
/// the highest in a step.
class GeneralizedAlpha : public FixedStepMethod {
 public:
  GeneralizedAlpha(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : FixedStepMethod(*spec.step, dynamics, start),
        tolerance_(spec.parameters.at("newton_tolerance") * dynamics.cable().length()),
        iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))) {
    const double rho = spec.parameters.at("spectral_radius");
    alpha_m_ = (2 * rho - 1) / (rho + 1);
    alpha_f_ = rho / (rho + 1);
    gamma_ = 0.5 - alpha_m_ + alpha_f_;
    beta_ = 0.25 * (1 - alpha_m_ + alpha_f_) * (1 - alpha_m_ + alpha_f_);
    dynamics.acceleration(start.q, a_);
    // What is wrong with the start itself is found by the first step.
    dynamics.take_collapsed();
  }

 private:
  StepResult advance(double h, const State& from, State& to) override {
    const double am = 1 - alpha_m_, af = 1 - alpha_f_;
    next_a_ = a_;
    CorrectionSize correction;
    for (int i = 0; i < iterations_; ++i) {
      to.q = from.q + h * from.v + h * h * ((0.5 - beta_) * a_ + beta_ * next_a_);
      middle_ = af * to.q + alpha_f_ * from.q;
      dynamics().force(middle_, residual_);
      if (const auto element = dynamics().take_collapsed())
        return {Outcome::singular, "the slope collapsed within Newton's iteration", *element};
      weighted_ = am * next_a_ + alpha_m_ * a_;
      dynamics().cable().mass().multiply(weighted_, inertia_);
      residual_ -= inertia_;
      dynamics().cable().supports().apply(residual_);
      if (const auto node = dynamics().factor(middle_, am, af * beta_ * h * h))
        return {Outcome::singular, "Newton's matrix is singular", *node};
      dynamics().solve(residual_);
      ++dynamics().counters.newton_iterations;
      next_a_ += residual_;
      residual_ *= beta_ * h * h;
      correction = correction_size(residual_, dynamics().cable().element().length());
      if (!std::isfinite(correction.metres)) break;
      if (correction.metres <= tolerance_) {
        to.q = from.q + h * from.v + h * h * ((0.5 - beta_) * a_ + beta_ * next_a_);
        to.v = from.v + h * ((1 - gamma_) * a_ + gamma_ * next_a_);
        std::swap(a_, next_a_);
        return {};
      }
    }
    return {Outcome::no_convergence,
            fmt::format(
                "Newton's iteration did not converge: its last correction was {:.3g} m, {:.3g} m is allowed",
                correction.metres, tolerance_),
            correction.element};
  }

  double tolerance_;  // m
  int iterations_;
  double alpha_m_, alpha_f_, beta_, gamma_;
  Eigen::VectorXd a_, next_a_;  // algorithmic accelerations
  Eigen::VectorXd middle_, weighted_, inertia_, residual_;
};

}  // namespace

MethodEntry generalized_alpha_entry() {
  MethodInfo info;
  info.name = "generalized-alpha";
  info.summary = "structural integrator with a chosen damping of high frequencies";
  info.source = "Chung and Hulbert 1993; Kuhl and Crisfield 1999";
  info.order = "2";
  info.conserves = "momentum";
  info.use = "stiff or fine cables, with a chosen damping";
  info.family = MethodFamily::structural;
  info.implicit = true;
  info.takes_step = true;
  info.parameters = newton_parameters();
  info.parameters.insert(
      info.parameters.begin(),
      {.name = "spectral_radius",
       .meaning = "amplification ρ∞ a step at infinite frequency; 1 conserves, 0 annihilates",
       .minimum = 0,
       .maximum = 1,
       .fallback = 0.8});
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<GeneralizedAlpha>(spec, dynamics, start);
          }};
}

}  // namespace plumb
