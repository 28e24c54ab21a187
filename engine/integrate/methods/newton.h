#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/integrate/method.h"
#include "engine/integrate/newton_leftover.h"

namespace plumb {

/// The keys of [method] that every method with Newton's iteration takes.
inline std::vector<MethodParameter> newton_parameters() {
  return {{.name = "newton_tolerance",
           .meaning = newton_tolerance_meaning,
           .minimum = 1e-15,
           .maximum = 1e-3,
           .fallback = 1e-9},
          {.name = "newton_iterations",
           .meaning = "most corrections in a step",
           .minimum = 1,
           .maximum = 100,
           .fallback = 50,
           .whole = true}};
}

/// Size of a correction of the nodal coordinates: the largest change of a position, or of a slope times the
/// element length, m, and the element it is at.
struct CorrectionSize {
  double metres = 0;
  int element = 0;
};

/// Of the correction scale · dq.
inline CorrectionSize correction_size(const Eigen::VectorXd& dq, double scale, double element_length) {
  CorrectionSize size;
  const auto nodes = static_cast<int>(dq.size() / 6);
  for (int node = 0; node < nodes; ++node) {
    const double largest =
        scale * std::max(dq.segment<3>(6 * node).lpNorm<Eigen::Infinity>(),
                         element_length * dq.segment<3>(6 * node + 3).lpNorm<Eigen::Infinity>());
    // What is not a number stays the answer.
    if (!(largest <= size.metres) || !dq.segment<6>(6 * node).allFinite())
      size = {dq.segment<6>(6 * node).allFinite() ? largest : std::numeric_limits<double>::infinity(),
              std::min(node, nodes - 2)};
  }
  return size;
}

/// What a correction of that size, m, leaves of an error; infinite where corrections grow. `before`: size of
/// the correction before it with the same matrix, 0 for the first. `fresh`: its matrix was made for it, and
/// leaves far less. One that is kept may turn what is small in one coordinate into something larger in
/// another, so that the contraction of the sizes promises too much: up to some hundred times, but hardly ever
/// more than twice the correction is left.
inline double left_after(double size, double before, bool fresh) {
  constexpr double trust = 200, growth = 2;
  if (fresh) return size;
  if (before <= 0) return trust * size;
  const double rate = size / before;
  if (!(rate < 1)) return std::numeric_limits<double>::infinity();
  const double promised = rate / (1 - rate);
  return size * std::max(promised, std::min(growth, trust * promised));
}

/// When a matrix that is kept over several steps has become dear: its corrections a step are more than with a
/// new one, whose price counts as so many corrections, they would be on average over its time.
class MatrixWear {
 public:
  explicit MatrixWear(double price) : price_(price) {}
  void renewed() { steps_ = corrections_ = 0; }
  void step_took(int corrections) {
    constexpr double latest = 4;  // steps that count
    ++steps_;
    corrections_ += corrections;
    recent_ = steps_ > 1 ? recent_ + (corrections - recent_) / latest : corrections;
  }
  /// That the matrix has lasted.
  double steps() const { return steps_; }
  bool is_worn() const { return steps_ > 0 && recent_ > (price_ + corrections_) / steps_; }

 private:
  double price_, recent_ = 0, corrections_ = 0, steps_ = 0;
};

/// Whether a matrix that is kept is turned with the nodes (Dynamics::correct). That costs each correction
/// some tenth more, and pays where a matrix lasts a few steps without it and twice as many with it.
class TurnChoice {
 public:
  bool turns() const { return turns_; }
  /// A matrix is renewed that has lasted so many steps.
  void lasted(double steps) {
    // One that does not outlast a step is outdone by more than turns.
    constexpr double fewest = 1, few = 10, many = 48, gain = 2;
    constexpr int tried = 4, pause = 64;
    if (pause_ > 0) {
      --pause_;
      return;
    }
    mean_ = (mean_ * count_ + steps) / (count_ + 1);
    if (++count_ < tried) return;
    const bool is_of_use = !turns_ || mean_ >= gain * plain_;
    if (!turns_) plain_ = mean_;
    turns_ = turns_ ? is_of_use && mean_ < many : mean_ >= fewest && mean_ < few;
    pause_ = is_of_use ? 0 : pause;
    count_ = 0;
    mean_ = 0;
  }

 private:
  bool turns_ = false;
  double mean_ = 0, plain_ = 0;  // steps that a matrix lasts: at present, and without turning
  int count_ = 0, pause_ = 0;    // matrices
};

/// Whether a correction of that size, m, after one of `before`, is round-off, which gets no smaller.
inline bool is_round_off(double size, double before, double cable_length) {
  constexpr double share = 3e-14, contracts = 0.15;
  return before > 0 && size > contracts * before && size <= share * cable_length;
}

/// The outcome of an iteration whose last correction was this, with `tolerance` and the cable's length in m.
inline StepResult not_converged(const CorrectionSize& correction, double tolerance, double length) {
  return {Outcome::no_convergence,
          fmt::format(
              "Newton's iteration did not converge: its last correction was {:.3g} of the cable's length, "
              "{:.3g} is allowed",
              correction.metres / length, tolerance / length),
          correction.element};
}

}  // namespace plumb
