#include "engine/model/greatest_eigenfrequency.h"

#include <Spectra/SymGEigsSolver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "engine/model/cable.h"

namespace plumb {
namespace {

/// P M P + m (I − P) with some m > 0, for Spectra: what is held has a mass, and as no stiffness holds it, the
/// frequency 0.
class Mass {
 public:
  using Scalar = double;

  explicit Mass(const Cable& cable)
      : cable_(cable),
        held_mass_(cable.constants().mass_per_length * cable.element().length()),
        x_(cable.size()),
        held_(cable.size()) {}

  Eigen::Index rows() const { return x_.size(); }
  Eigen::Index cols() const { return x_.size(); }
  void perform_op(const double* x, double* y) const {
    split(x);
    cable_.mass().multiply(x_, y_);
    cable_.supports().apply(y_);
    Eigen::Map<Eigen::VectorXd>(y, rows()) = y_ + held_mass_ * held_;
  }
  void solve(const double* x, double* y) const {
    split(x);
    cable_.mass().solve(x_, scratch_);
    cable_.supports().apply(x_);
    Eigen::Map<Eigen::VectorXd>(y, rows()) = x_ + held_ / held_mass_;
  }

 private:
  /// x = x_ + held_.
  void split(const double* x) const {
    held_ = x_ = Eigen::Map<const Eigen::VectorXd>(x, rows());
    cable_.supports().apply(x_);
    held_ -= x_;
  }

  const Cable& cable_;
  double held_mass_;  // kg
  mutable Eigen::VectorXd x_, y_, held_, scratch_;
};

/// P K P for Spectra, or that over a square of a frequency and plus the Mass, in which nothing has the
/// frequency 0.
class Stiffness {
 public:
  using Scalar = double;

  Stiffness(const Cable& cable, const Eigen::VectorXd& q, const Mass& mass)
      : supports_(cable.supports()), mass_(mass), matrix_(cable.nodes()), x_(cable.size()) {
    cable.system(q, 0, 1, matrix_);
  }

  bool is_finite() const {
    const std::span entries(matrix_.data(), static_cast<std::size_t>(matrix_.nodes() * block_column_size));
    return std::ranges::all_of(entries, [](double entry) { return std::isfinite(entry); });
  }

  void shift_and_scale(double square) { square_ = square; }

  Eigen::Index rows() const { return x_.size(); }
  Eigen::Index cols() const { return x_.size(); }
  void perform_op(const double* x, double* y) const {
    x_ = Eigen::Map<const Eigen::VectorXd>(x, rows());
    supports_.apply(x_);
    matrix_.multiply(x_, y_);
    supports_.apply(y_);
    Eigen::Map<Eigen::VectorXd> result(y, rows());
    if (!square_) {
      result = y_;
      return;
    }
    mass_.perform_op(x, y);
    result += y_ / *square_;
  }

 private:
  const SupportProjection& supports_;
  const Mass& mass_;
  std::optional<double> square_;  // 1/s²
  BlockTridiagonal matrix_;
  mutable Eigen::VectorXd x_, y_;
};

/// About the size of ω², 1/s²: how long M⁻¹ K makes some vector, in the norm of M.
double typical_square(const Stiffness& stiffness, const Mass& mass) {
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(stiffness.rows(), 1, 2), y = x, z = x;
  for (Eigen::Index i = 0; i < x.size(); i += 2) x[i] = -x[i];
  mass.perform_op(x.data(), y.data());
  const double before = x.dot(y);
  stiffness.perform_op(x.data(), z.data());
  mass.solve(z.data(), y.data());
  return std::sqrt(std::max(0.0, y.dot(z)) / before);  // as z = M y
}

/// The element at whose nodes the shape moves most.
int place_of(const Eigen::VectorXd& shape, const Cable& cable) {
  int greatest_node = 0;
  double greatest = 0;
  for (int node = 0; node < cable.nodes(); ++node) {
    const double moves = std::max(shape.segment<3>(6 * node).norm(),
                                  cable.element().length() * shape.segment<3>(6 * node + 3).norm());
    if (moves > greatest) {
      greatest = moves;
      greatest_node = node;
    }
  }
  return std::min(greatest_node, cable.elements() - 1);
}

}  // namespace

namespace {

FastestVibration in_own_units(const Cable& cable, const Eigen::VectorXd& q) {
  // Lanczos's vectors held at a time. Where vibrations are few and alike the library seeks new directions at
  // random, for which there must be room.
  constexpr int vectors = 24;
  // A vibration that is gathered at an end or where the cable is stretched most is found at once. One that
  // spreads along a fine, even cable has neighbours of almost its frequency: any of them will do.
  struct Attempt {
    int restarts;
    double residual;  // left, as a fraction of ω²
  };
  constexpr std::array attempts{Attempt{3, 1e-6}, Attempt{300, 1e-3}};
  FastestVibration result;
  result.shape.setZero(cable.size());
  Mass mass(cable);
  Stiffness stiffness(cable, q, mass);
  if (!stiffness.is_finite()) return result;
  // The library tells round-off from numbers by sizes that suit numbers near 1, and seeks new directions in
  // what the matrix makes of random ones.
  const double square = typical_square(stiffness, mass);
  if (!(square > 0)) return result;
  stiffness.shift_and_scale(square);
  Spectra::SymGEigsSolver<Stiffness, Mass, Spectra::GEigsMode::RegularInverse> solver(
      stiffness, mass, 1, std::min(vectors, cable.size() / 2));
  for (const auto& [restarts, residual] : attempts) {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge, restarts, residual);
    if (solver.info() == Spectra::CompInfo::Successful) break;
  }
  if (solver.info() != Spectra::CompInfo::Successful) return result;
  const double scaled = solver.eigenvalues()[0] - 1;
  if (!(scaled > 0)) return result;
  result.frequency = std::sqrt(scaled * square);
  result.shape = solver.eigenvectors().col(0);
  result.element = place_of(result.shape, cable);
  return result;
}

}  // namespace

FastestVibration fastest_vibration(const Cable& cable, const Eigen::VectorXd& q) {
  const ElementConstants& c = cable.constants();
  // That of sound along the cable.
  const double time = cable.length() * std::sqrt(c.mass_per_length / c.axial_stiffness);
  const OwnUnits units = OwnUnits::of(cable.length(), std::isnormal(time) ? time : 1, cable.total_mass());
  Eigen::VectorXd own_q = q;
  scale_nodal(1 / units.length, 1, own_q);
  FastestVibration result = in_own_units(cable.in_units(units), own_q);
  result.frequency /= units.time;
  // Modal masses are 1 in either.
  const double root = std::sqrt(units.mass);
  scale_nodal(1 / root, 1 / (root * units.length), result.shape);
  return result;
}

double fastest_frequency_at_start(const Case& spec) {
  const Cable cable(spec);
  return cable.is_rigid() ? 0 : fastest_vibration(cable, cable.start_q(spec.start)).frequency;
}

}  // namespace plumb
