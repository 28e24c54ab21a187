#pragma once

#include <array>
#include <utility>

#include "engine/integrate/methods/implicit_stage.h"
#include "engine/integrate/methods/newton.h"
#include "engine/integrate/methods/one_step_method.h"

namespace plumb {

/// A step of Newmark's kind (Newmark 1959; Chung and Hulbert 1993) with one implicit stage for an
/// acceleration x:
///   q₁ = q₀ + h v₀ + h² (position_old a₀ + position_new x),
///   v₁ = v₀ + h (velocity_old a₀ + velocity_new x),
///   M (mass_new x + mass_old a₀) = force_new f(point q₁ + (1 − point) q₀) + force_old f(q₀),
/// where a₀ is the x of the step before, or the true acceleration at the start. All are pure numbers;
/// position_new, mass_new, force_new and point are > 0.
struct StructuralScheme {
  double position_old, position_new;
  double velocity_old, velocity_new;
  double mass_old = 0, mass_new = 1;
  double force_old = 0, force_new = 1;
  double point = 1;
  double time = 1;  ///< of x within the step, as a fraction of h
  int order = 2;
  /// The error of q in a step is error h² (x − a₀) for order 2, with the difference taken over h, and error
  /// h² x for order 1.
  double error = 0;
};

/// Newmark's scheme (1959) with the parameters β and γ, of order 2:
///   q₁ = q₀ + h v₀ + h² ((½ − β) a₀ + β x),   v₁ = v₀ + h ((1 − γ) a₀ + γ x),   M x = f(q₁).
constexpr StructuralScheme newmark(double beta, double gamma) {
  StructuralScheme scheme{
      .position_old = 0.5 - beta, .position_new = beta, .velocity_old = 1 - gamma, .velocity_new = gamma};
  scheme.error = beta - 1.0 / 6;
  return scheme;
}

/// The implicit midpoint rule: one stage, for the acceleration there.
inline constexpr StructuralScheme midpoint_scheme{.position_old = 0,
                                                  .position_new = 0.5,
                                                  .velocity_old = 0,
                                                  .velocity_new = 1,
                                                  .point = 0.5,
                                                  .time = 0.5,
                                                  .error = 1.0 / 12};

/// The one-step method of a StructuralScheme.
class StructuralMethod : public OneStepMethod {
 public:
  StructuralMethod(const StructuralScheme& scheme, const MethodSpec& spec, Dynamics& dynamics,
                   const State& start);

 private:
  StepResult advance(double h, const State& from, State& to) override;
  void estimate_error(double h, const State& from, const State& to, Eigen::VectorXd& e) override;
  void accept() override;

  /// From x of the steps before: that with which q₁ is q₀ + h v₀, which is the best one where accelerations
  /// change at once, such as at a start, where those beside a support grow with the fineness of the mesh; the
  /// last one; and by lines and parabolas through the last.
  enum Guess { coasting, constant, linear, quadratic };

  /// Time between x of this step of h and of the last, s.
  double between(double h) const { return scheme_.time * h + (1 - scheme_.time) * last_h_; }
  /// What x of the last steps counts in a guess, the latest first.
  std::array<double, 3> weights(Guess guess, double over) const;
  StepResult solve(Guess guess, double h, StageTerms& stage, const Instant& at);
  /// That which would have been nearest to x in the step just made: a line or a parabola where it is clearly
  /// nearer than `next_plain_`.
  Guess nearest_guess(double h) const;

  StructuralScheme scheme_;
  ImplicitStage stage_;
  Eigen::VectorXd a_, next_a_;             // x of the last step and of this one
  std::array<Eigen::VectorXd, 2> past_a_;  // and of those before, the latest first
  std::array<double, 2> gaps_{};           // between x of the last steps, s; 0: there is none
  Eigen::VectorXd guess_;
  Eigen::VectorXd old_force_, force_;               // f(q₀) and f(q₁), where the scheme needs them
  Guess plain_ = coasting, next_plain_ = coasting;  // the one of the first two that serves
  Guess first_guess_ = coasting, next_guess_ = coasting;
  int steps_since_look_ = 0;   // of nearest_guess
  double h_ = 0, last_h_ = 0;  // of this step and the last, s; 0: none
};

/// Spectral radius of a step of the scheme for a vibration with ωh = z (MethodInfo::amplification).
double structural_amplification(const StructuralScheme& scheme, double z);

/// Its NewtonMatrix.
NewtonMatrix structural_matrix(const StructuralScheme& scheme);

/// What the methods of this kind share in their description; `name`, `summary` and so on are left to them.
/// `scheme` gives that of a MethodSpec; it must have no captures.
template <class Scheme>
MethodInfo structural_info(Scheme /*scheme*/) {
  MethodInfo info;
  info.order = "2";
  info.conserves = "momentum";
  info.family = MethodFamily::structural;
  info.implicit = true;
  info.takes_step = true;
  info.takes_tolerances = true;
  info.rtol = 1e-5;
  info.parameters = newton_parameters();
  info.cost = {1000, 1500};
  info.amplification = [](const MethodSpec& spec, double z) {
    return structural_amplification(Scheme{}(spec), z);
  };
  info.newton_matrix = [](const MethodSpec& spec) { return structural_matrix(Scheme{}(spec)); };
  return info;
}

/// The entry of a method that is a StructuralMethod with that scheme and no more.
template <class Scheme>
MethodEntry structural_entry(MethodInfo info, Scheme /*scheme*/) {
  return {std::move(info),
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<StructuralMethod>(Scheme{}(spec), spec, dynamics, start);
          }};
}

}  // namespace plumb
