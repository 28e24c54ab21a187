#include "engine/model/greatest_eigenfrequency.h"

#include <Spectra/SymGEigsSolver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace plumb {
namespace {

/// P K P, for Spectra.
class Stiffness {
 public:
  using Scalar = double;

  Stiffness(const Cable& cable, const Eigen::VectorXd& q)
      : supports_(cable.supports()), matrix_(cable.nodes()), x_(cable.size()) {
    cable.system(q, 0, 1, matrix_);
  }

  bool is_finite() const {
    const std::span entries(matrix_.data(), static_cast<std::size_t>(matrix_.nodes() * block_column_size));
    return std::ranges::all_of(entries, [](double entry) { return std::isfinite(entry); });
  }

  Eigen::Index rows() const { return x_.size(); }
  Eigen::Index cols() const { return x_.size(); }
  void perform_op(const double* x, double* y) const {
    x_ = Eigen::Map<const Eigen::VectorXd>(x, rows());
    supports_.apply(x_);
    matrix_.multiply(x_, y_);
    supports_.apply(y_);
    Eigen::Map<Eigen::VectorXd>(y, rows()) = y_;
  }

 private:
  const SupportProjection& supports_;
  BlockTridiagonal matrix_;
  mutable Eigen::VectorXd x_, y_;
};

/// P M P + m (I − P) with some m > 0, for Spectra: what is held has a mass, and as no stiffness holds it, the
/// frequency 0.
class Mass {
 public:
  using Scalar = double;

  explicit Mass(const Cable& cable)
      : cable_(cable),
        held_mass_(cable.constants().mass_per_length * cable.element().length()),
        x_(cable.size()),
        held_(cable.size()) {
    // Coordinates that no force moves are held as well: a model may have no use for its slopes.
    Eigen::VectorXd moved = Eigen::VectorXd::Random(cable.size());
    cable.mass().solve(moved, scratch_);
    moves_ = (moved.array() != 0).cast<double>();
  }

  Eigen::Index rows() const { return x_.size(); }
  Eigen::Index cols() const { return x_.size(); }
  void perform_op(const double* x, double* y) const {
    split(x);
    cable_.mass().multiply(x_, y_);
    take_part(y_);
    Eigen::Map<Eigen::VectorXd>(y, rows()) = y_ + held_mass_ * held_;
  }
  void solve(const double* x, double* y) const {
    split(x);
    cable_.mass().solve(x_, scratch_);
    take_part(x_);
    Eigen::Map<Eigen::VectorXd>(y, rows()) = x_ + held_ / held_mass_;
  }

 private:
  void take_part(Eigen::VectorXd& x) const {
    cable_.supports().apply(x);
    x.array() *= moves_;
  }
  /// x = x_ + held_.
  void split(const double* x) const {
    held_ = x_ = Eigen::Map<const Eigen::VectorXd>(x, rows());
    take_part(x_);
    held_ -= x_;
  }

  const Cable& cable_;
  double held_mass_;  // kg
  Eigen::ArrayXd moves_;
  mutable Eigen::VectorXd x_, y_, held_, scratch_;
};

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

FastestVibration fastest_vibration(const Cable& cable, const Eigen::VectorXd& q) {
  // Lanczos's vectors held at a time.
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
  Stiffness stiffness(cable, q);
  if (!stiffness.is_finite()) return result;
  Mass mass(cable);
  Spectra::SymGEigsSolver<Stiffness, Mass, Spectra::GEigsMode::RegularInverse> solver(
      stiffness, mass, 1, std::min(vectors, cable.size()));
  for (const auto& [restarts, residual] : attempts) {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge, restarts, residual);
    if (solver.info() == Spectra::CompInfo::Successful) break;
  }
  if (solver.info() != Spectra::CompInfo::Successful || !(solver.eigenvalues()[0] > 0)) return result;
  result.frequency = std::sqrt(solver.eigenvalues()[0]);
  result.shape = solver.eigenvectors().col(0);
  result.element = place_of(result.shape, cable);
  return result;
}

}  // namespace plumb
