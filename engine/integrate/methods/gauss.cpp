#include <Eigen/LU>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "engine/base/dense.h"
#include "engine/integrate/linear_stability.h"
#include "engine/integrate/methods/newton.h"
#include "engine/integrate/methods/one_step_method.h"
#include "engine/kernels/kernels.h"
#include "engine/model/block_lu.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

using Complex = std::complex<double>;

/// The Butcher table of the Gauss method of three stages (Hairer, Lubich and Wanner 2006, section II.1.3).
struct GaussTable {
  static constexpr int stages = 3;
  Eigen::Vector3d c, b;
  Eigen::Matrix3d A;

  GaussTable() {
    const double root = std::sqrt(15.0);
    c << 0.5 - root / 10, 0.5, 0.5 + root / 10;
    b << 5.0 / 18, 4.0 / 9, 5.0 / 18;
    A << 5.0 / 36, 2.0 / 9 - root / 15, 5.0 / 36 - root / 30,  //
        5.0 / 36 + root / 24, 2.0 / 9, 5.0 / 36 - root / 24,   //
        5.0 / 36 + root / 30, 2.0 / 9 + root / 15, 5.0 / 36;
  }
};

constexpr int stages = GaussTable::stages;
using Weights = Eigen::Vector3d;

/// Of new factors, in corrections with the old ones.
constexpr double price_of_factors = 5;
/// Contraction of the corrections above which they pay for themselves within a step.
constexpr double slow_stages = 0.2;
/// Contraction above which the old factors lead astray, and the step begins anew.
constexpr double stages_astray = 1;

/// The weights of a GaussTable for q'' = g(q).
struct Tableau {
  Weights c, b;
  Eigen::Matrix3d velocity;  ///< A: of the stages' velocities
  Eigen::Matrix3d position;  ///< A²: of the stages' positions
  Weights end_position;      ///< bᵀA

  /// A² = T diag(λ²) T⁻¹ with one real λ and one pair of complex ones, of which one is kept.
  double real;  ///< λ
  Complex pair;
  Weights real_column, real_row;  ///< of T and of T⁻¹
  Eigen::Vector3cd pair_column, pair_row;

  explicit Tableau(const GaussTable& table = {}) : c(table.c), b(table.b) {
    const Eigen::Matrix3d& A = table.A;
    velocity = A;
    position = A * A;
    end_position = A.transpose() * b;
    const auto [values, vectors] = general_eigen(Eigen::MatrixXd(A));
    const Eigen::Matrix3cd columns = vectors, rows = columns.inverse();
    for (int i = 0; i < stages; ++i) {
      const Complex lambda = values[i];
      if (lambda.imag() == 0) {
        real = lambda.real();
        real_column = columns.col(i).real();
        real_row = rows.row(i).real().transpose();
      } else if (lambda.imag() > 0) {
        pair = lambda;
        pair_column = columns.col(i);
        pair_row = rows.row(i).transpose();
      }
    }
  }

  /// The polynomials that are 1 at one c and 0 at the others, at x.
  Weights lagrange(double x) const {
    Weights result;
    for (int j = 0; j < stages; ++j) {
      const double one = c[(j + 1) % stages], other = c[(j + 2) % stages];
      result[j] = (x - one) * (x - other) / ((c[j] - one) * (c[j] - other));
    }
    return result;
  }

  /// Their integrals from 0 to x, once and twice.
  std::pair<Weights, Weights> integrals(double x) const {
    std::pair<Weights, Weights> result;
    for (int j = 0; j < stages; ++j) {
      const double one = c[(j + 1) % stages], other = c[(j + 2) % stages];
      const double sum = one + other, product = one * other, scale = 1 / ((c[j] - one) * (c[j] - other));
      result.first[j] = scale * x * (x * x / 3 - x * sum / 2 + product);
      result.second[j] = scale * x * x * (x * x / 12 - x * sum / 6 + product / 2);
    }
    return result;
  }
};

/// The Gauss method of three stages, of order 6. Its stages' accelerations Xᵢ solve
///   M Xᵢ = f(t + cᵢ h, Qᵢ, Vᵢ),  Qᵢ = q + cᵢ h v + h² Σ (A²)ᵢⱼ Xⱼ,  Vᵢ = v + h Σ Aᵢⱼ Xⱼ,
/// by Newton's iteration with one K and one C = −∂f/∂v for all stages, which falls apart into one real and
/// one complex system (Hairer and Wanner 1996, section IV.8). Factors are kept as long as they serve, as in
/// ImplicitStage.
class Gauss : public OneStepMethod {
 public:
  Gauss(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : OneStepMethod(spec, 6, dynamics, start),
        tolerance_(spec.parameters.at("newton_tolerance") * dynamics.cable().length()),
        iterations_(static_cast<int>(spec.parameters.at("newton_iterations"))),
        mass_(dynamics.cable().nodes()),
        stiffness_(dynamics.cable().nodes()),
        matrix_(dynamics.cable().nodes()) {
    dynamics.cable().system(start.q, 1, 0, mass_);
    dynamics.cable().supports().apply(mass_);
    dynamics.acceleration(start, last_x_[0]);
    dynamics.take_collapsed();
    last_x_[2] = last_x_[1] = last_x_[0];
    guess_ = residual_ = x_ = last_x_;
    complex_.resize(start.q.size());
  }

  /// The polynomial of collocation: of degree 4 in q, it joins both ends and has the stages' accelerations.
  void interpolate(double t, State& at) const override {
    const State& from = before();
    const double h = state().t - from.t, x = (t - from.t) / h;
    const auto [once, twice] = tableau_.integrals(x);
    at.t = t;
    at.q.resize(from.q.size());
    at.v.resize(from.v.size());
    add_stages(from.q, &from.v, x * h, last_x_, h * h * twice, at.q);
    add_stages(from.v, nullptr, 0, last_x_, h * once, at.v);
  }

 private:
  using Stages = std::array<Eigen::VectorXd, stages>;

  StepResult advance(double h, const State& from, State& to) override {
    for (int i = 0; i < stages; ++i) {
      // Before the first step all three are the acceleration of the start.
      const Weights weights = tableau_.lagrange(last_h_ > 0 ? 1 + h / last_h_ * tableau_.c[i] : 0.5);
      x_[at(i)].setZero();
      add_stages(x_[at(i)], nullptr, 0, last_x_, weights, x_[at(i)]);
    }
    StepResult result = solve(h, from);
    if (!result.ok()) {
      // A step that is large against the fastest motion is out of reach of the last accelerations.
      for (Eigen::VectorXd& x : x_) x.setZero();
      result = solve(h, from);
      if (!result.ok()) return result;
    }
    h_ = h;
    add_stages(from.q, &from.v, h, x_, h * h * tableau_.end_position, to.q);
    add_stages(from.v, nullptr, 0, x_, h * tableau_.b, to.v);
    return result;
  }

  StepResult solve(double h, const State& from) {
    const Cable& cable = dynamics().cable();
    bool renew = factored_h_ != h || wear_.is_worn();
    bool old = !renew;  // the factors are those of an earlier step
    guess_ = x_;
    CorrectionSize correction;
    double before = 0;  // size of the correction before this one
    for (int i = 0; i < iterations_; ++i) {
      if (const StepResult result = residuals(h, from); !result.ok()) return result;
      if (renew) {
        if (const auto node = factor(h, from))
          return {Outcome::singular, "Newton's matrix is singular", std::min(*node, cable.elements() - 1)};
        old = false;
      }
      correct();
      ++dynamics().counters.newton_iterations;
      correction = {};
      for (const Eigen::VectorXd& change : residual_) {
        const CorrectionSize own = correction_size(change, 0.5 * h * h, cable.element().length());
        if (!(own.metres <= correction.metres)) correction = own;
        if (!std::isfinite(own.metres)) break;
      }
      if (!std::isfinite(correction.metres)) break;
      const double rate = before > 0 ? correction.metres / before : 1;
      if (left_after(correction.metres, before, renew) <= tolerance_ ||
          is_round_off(correction.metres, before, cable.length())) {
        wear_.step_took(i + 1);
        return {};
      }
      renew = old && before > 0 && rate > slow_stages;
      if (old && before > 0 && rate > stages_astray) {
        x_ = guess_;
        before = 0;
        continue;
      }
      before = correction.metres;
    }
    factored_h_ = 0;
    return not_converged(correction, tolerance_, cable.length());
  }

  /// Rᵢ = f(Qᵢ) − M Xᵢ; leaves the middle stage's Qᵢ in middle_.
  StepResult residuals(double h, const State& from) {
    const Cable& cable = dynamics().cable();
    for (int i = 0; i < stages; ++i) {
      Eigen::VectorXd &point = i == stages / 2 ? middle_ : point_, &residual = residual_[at(i)];
      point.resize(from.q.size());
      add_stages(from.q, &from.v, tableau_.c[i] * h, x_, h * h * tableau_.position.row(i).transpose(), point);
      dynamics().force(point, residual, stage_instant(h, from, i));
      if (const auto element = dynamics().take_collapsed()) {
        factored_h_ = 0;
        if (!point.allFinite()) return {Outcome::no_convergence, "Newton's iteration left the numbers", -1};
        return {Outcome::singular, "the slope collapsed within Newton's iteration", *element};
      }
      cable.mass().multiply(x_[at(i)], inertia_);
      residual -= inertia_;
      cable.supports().apply(residual);
    }
    return {};
  }

  /// When and at which rates a stage is; these are only added up where they count.
  Instant stage_instant(double h, const State& from, int stage) {
    Instant at{from.t + tableau_.c[stage] * h};
    if (dynamics().cable().conservative()) return at;
    velocity_.resize(from.v.size());
    add_stages(from.v, nullptr, 0, x_, h * tableau_.velocity.row(stage).transpose(), velocity_);
    at.v = velocity_.data();
    return at;
  }

  /// Factors M + λ h C + λ² h² K with those of the middle stage, for the real λ and one of the pair.
  std::optional<int> factor(double h, const State& from) {
    factored_h_ = 0;
    const double real = h * tableau_.real;
    const Complex pair = h * tableau_.pair;
    const Instant middle = stage_instant(h, from, stages / 2);
    if (const auto node = dynamics().factor(middle_, 1, real * real, middle, real)) return node;
    const Cable& cable = dynamics().cable();
    // What the supports hold gets 1 + λ² h² on the diagonal, and a right-hand side of 0.
    if (cable.conservative()) {
      cable.system(middle_, 0, 1, stiffness_);
      cable.supports().apply(stiffness_);
      matrix_.set_sum(mass_, pair * pair, stiffness_);
    } else {
      matrix_.set_sum(mass_, 0, mass_);
      GeneralBlockTridiagonal<double> part(cable.nodes());
      dynamics().general_system(middle_, 0, 1, middle, 0, part);
      cable.supports().apply(part);
      matrix_.add(pair * pair, part);
      dynamics().general_system(middle_, 0, 0, middle, 1, part);
      cable.supports().apply(part);
      matrix_.add(pair, part);
    }
    ++dynamics().counters.tangent_evaluations;
    ++dynamics().counters.factorizations;
    if (const auto node = lu_.factor(matrix_)) return node;
    factored_h_ = h;
    wear_.renewed();
    return std::nullopt;
  }

  /// Turns the residuals into the corrections of X and adds them.
  void correct() {
    const Stages& R = residual_;
    const auto &row = tableau_.real_row, &column = tableau_.real_column;
    const auto &pair_row = tableau_.pair_row, &pair_column = tableau_.pair_column;
    real_ = row[0] * R[0] + row[1] * R[1] + row[2] * R[2];
    complex_.real() = pair_row[0].real() * R[0] + pair_row[1].real() * R[1] + pair_row[2].real() * R[2];
    complex_.imag() = pair_row[0].imag() * R[0] + pair_row[1].imag() * R[1] + pair_row[2].imag() * R[2];
    dynamics().solve(real_);
    lu_.solve(complex_);
    for (int i = 0; i < stages; ++i) {
      // The other one of the pair adds the conjugate.
      residual_[at(i)] = column[i] * real_ + (2 * pair_column[i].real()) * complex_.real() -
                         (2 * pair_column[i].imag()) * complex_.imag();
      // Round-off of the two systems must not move what is held.
      dynamics().cable().supports().apply(residual_[at(i)]);
      x_[at(i)] += residual_[at(i)];
    }
  }

  void accept() override {
    std::swap(x_, last_x_);
    last_h_ = h_;
  }

  static std::size_t at(int stage) { return static_cast<std::size_t>(stage); }

  /// result := first + reach rate + Σ weights Xⱼ.
  static void add_stages(const Eigen::VectorXd& first, const Eigen::VectorXd* rate, double reach,
                         const Stages& x, const Weights& weights, Eigen::VectorXd& result) {
    Sum sum(first);
    for (int i = 0; i < stages; ++i) sum.plus(weights[i], x[at(i)]);
    if (rate != nullptr) sum.plus(reach, *rate);
    best_kernels().add_up(static_cast<int>(first.size()) / 6, sum.into(result));
  }

  Tableau tableau_;
  double tolerance_;  // m
  int iterations_;
  double h_ = 0, last_h_ = 0;  // of this step and the last, s; 0: none
  Stages x_, last_x_;          // accelerations of this step and the last
  Stages guess_, residual_;
  double factored_h_ = 0;  // s; 0: no factors
  MatrixWear wear_{price_of_factors};
  BlockTridiagonal mass_, stiffness_;
  GeneralBlockTridiagonal<Complex> matrix_;
  BlockLu<Complex> lu_;
  Eigen::VectorXd point_, middle_, velocity_, inertia_, real_;
  Eigen::VectorXcd complex_;
};

double gauss_amplification(const MethodSpec&, double z) {
  const GaussTable table;
  return runge_kutta_amplification(table.A, table.b, z);
}

}  // namespace

MethodEntry gauss_entry() {
  MethodInfo info;
  info.name = "gauss";
  info.summary = "Gauss collocation of three stages";
  info.source = "Hairer, Lubich and Wanner 2006, section II.1.3";
  info.order = "6";
  info.stage_order = stages;
  info.conserves = "momentum, angular momentum; symplectic";
  info.use = "stiff or fine cables to high accuracy";
  info.family = MethodFamily::implicit_stages;
  info.implicit = true;
  info.takes_step = true;
  info.cost = {6200, 10000};
  info.amplification = gauss_amplification;
  info.parameters = newton_parameters();
  // Less than the errors of a high order.
  info.parameters.front().fallback = 1e-13;
  return {info, made<Gauss>};
}

}  // namespace plumb
