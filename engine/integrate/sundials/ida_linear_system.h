#pragma once

#include "engine/integrate/sundials/library_linear_solver.h"
#include "engine/model/support_constraints.h"

namespace plumb::sundials {

/// IDA's Newton system for q' = v + Gᵀ μ, M v' = f(t, q, v) + Gᵀ λ, G v = 0, G q = G q₀ with corrections of
/// (q, v, λ, μ) and right-hand sides (b₁, b₂, b₃, b₄):
///   c dq − dv − Gᵀ dμ = b₁,   (c M + C) dv + K dq − Gᵀ dλ = b₂,   G dv = b₃,   G dq = b₄,
/// c being IDA's leading coefficient over the step. As G Gᵀ = I, the first rows give dμ and dv, and what
/// remains is the block banded matrix S = M + C / c + K / c² between the held coordinates, dq = Gᵀ b₄ + P z:
///   dμ = c b₄ − b₃ − G b₁,   dv = c dq − Gᵀ dμ − b₁,
///   P S P z = P (r − S Gᵀ b₄),   dλ = c² G (S dq − r),   r = b₂ / c² + (M / c + C / c²) (b₁ + Gᵀ dμ).
/// Without stabilisation there are no μ and b₄; G dq = (G b₁ + b₃) / c takes the part of b₄.
class IdaLinearSystem : public LinearSystem {
 public:
  /// Both must outlive it.
  IdaLinearSystem(Dynamics& dynamics, const SupportConstraints& constraints, bool stabilised);

  /// Prepares the system at t (s) and y. Returns 1 if the matrix is singular (the library tries a shorter
  /// step), else 0.
  int prepare(double t, N_Vector y, double leading);

  void solve(N_Vector solution, N_Vector right_hand_side) override;

 private:
  Dynamics& dynamics_;
  const SupportConstraints& constraints_;
  bool stabilised_;
  double t_ = 0;                                 // s
  double c_ = 0;                                 // 1/s
  GeneralBlockTridiagonal<double> free_system_;  // S without supports
  Eigen::VectorXd q_, dq_, z_, r_, rates_, product_;
};

}  // namespace plumb::sundials
