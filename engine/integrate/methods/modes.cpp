#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/integrate/methods/equilibrium_path.h"
#include "engine/integrate/methods/resting_cable.h"
#include "engine/model/cable.h"
#include "engine/model/complex_modes.h"

namespace plumb {
namespace {

enum class About { equilibrium, start };

/// Free vibrations of small size, M ẍ + D ẋ + K x = 0, about a place where the cable rests, in a frame that
/// turns with it.
class Modes : public Method {
 public:
  Modes(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : dynamics_(dynamics), count_(static_cast<int>(spec.parameters.at("count"))), rest_(start) {
    const Vec3& spin = dynamics.cable().spin();
    found_.spin = spin.norm();
    if (found_.spin > 0) found_.axis = spin / found_.spin;
    if (static_cast<About>(static_cast<int>(spec.parameters.at("about"))) == About::equilibrium) {
      Rest rest = find_rest(dynamics, start.q);
      conclusion_ = rest.failure;
      if (!conclusion_.ok()) return;
      rest_.q = std::move(rest.q);
    }
    for (Eigen::Index at = 0; at < rest_.q.size(); at += 3)
      rest_.v.segment<3>(at) = spin.cross(rest_.q.segment<3>(at));
    dynamics.cable().supports().apply(rest_.v);
    look_for_modes();
  }

  StepResult step(double) override { return conclusion_; }
  const State& state() const override { return rest_; }
  void interpolate(double, State& at) const override { at = rest_; }
  StepResult conclusion() const override { return conclusion_; }
  void add_to(Trajectory& trajectory) const override { trajectory.vibrations = found_; }

 private:
  void look_for_modes() {
    Eigen::VectorXd force;
    dynamics_.force(rest_.q, force, {.t = dynamics_.times().duration, .still = true});
    if (const auto element = dynamics_.take_collapsed()) {
      conclusion_ = {Outcome::singular, "the slope of an element has collapsed", *element};
      return;
    }
    const SmallMotions motions(dynamics_.cable(), rest_.q, dynamics_.times().duration);
    std::string failure;
    int growing = 0;
    if (motions.has_rates() || !motions.has_symmetric_stiffness()) {
      ComplexModes modes = complex_modes(motions, count_);
      failure = std::move(modes.failure);
      for (const ComplexMode& mode : modes.modes) found_.modes.push_back(shown(mode));
    } else {
      const LowestModes modes = lowest_modes(motions, count_);
      failure = modes.failure;
      for (Eigen::Index k = 0; k < std::min<Eigen::Index>(count_, modes.squares.size()); ++k)
        found_.modes.push_back(shown(motions, modes, k));
      found_.orthonormality = orthonormality(motions);
      growing = modes.negative;
    }
    std::ranges::stable_sort(found_.modes, {}, [](const VibrationMode& mode) {
      return mode.kind == ModeKind::growing ? 0 : mode.kind == ModeKind::rigid_body ? 1 : 2;
    });
    const auto count_of = [&](ModeKind kind) {
      return static_cast<int>(std::ranges::count(found_.modes, kind, &VibrationMode::kind));
    };
    found_.rigid_body = count_of(ModeKind::rigid_body);
    growing = std::max(growing, count_of(ModeKind::growing));
    if (!failure.empty()) {
      conclusion_ = {Outcome::no_convergence, failure, -1};
    } else if (growing > 0) {
      const std::string_view leaves = "the cable would leave this equilibrium at the least disturbance";
      conclusion_ = {Outcome::unstable_equilibrium,
                     motions.has_rates() || !motions.has_symmetric_stiffness()
                         ? fmt::format("{} of the modes grow{}: {}", growing, growing == 1 ? "s" : "", leaves)
                         : fmt::format("{}: the stiffness has {}", leaves, eigenvalues_in_words(growing)),
                     -1};
    }
  }

  /// One of K φ = ω² M φ.
  static VibrationMode shown(const SmallMotions& motions, const LowestModes& modes, Eigen::Index k) {
    const double square = modes.squares[k], size = std::sqrt(std::abs(square));
    VibrationMode mode;
    mode.shape = modes.shapes.col(k);
    mode.kind = k < modes.rigid_body ? ModeKind::rigid_body
                : square > 0         ? ModeKind::vibration
                : square < 0         ? ModeKind::growing
                                     : ModeKind::slack;
    if (square > 0) mode.frequency = size / (2 * std::numbers::pi);
    if (square < 0) mode.decay = -size;
    Eigen::VectorXd Kx, Mx;
    motions.stiffness_times(mode.shape, Kx);
    motions.mass_times(mode.shape, Mx);
    const double scale = Kx.norm() + std::abs(square) * Mx.norm();
    mode.residual = scale > 0 && square != 0 ? (Kx - square * Mx).norm() / scale : 0;
    return mode;
  }

  static VibrationMode shown(const ComplexMode& given) {
    constexpr double grows = 1e-9, as_good_as_real = 1e-12;
    VibrationMode mode;
    const double size = std::abs(given.exponent);
    mode.frequency = given.exponent.imag() / (2 * std::numbers::pi);
    mode.decay = 0 - given.exponent.real();
    mode.damping_ratio = given.damping_ratio;
    mode.residual = given.residual;
    mode.kind = given.rigid_body             ? ModeKind::rigid_body
                : mode.decay < -grows * size ? ModeKind::growing
                : mode.frequency > 0         ? ModeKind::vibration
                : size > 0                   ? ModeKind::overdamped
                                             : ModeKind::slack;
    mode.shape = given.shape.real();
    if (given.shape.imag().norm() > as_good_as_real * mode.shape.norm()) mode.quadrature = given.shape.imag();
    return mode;
  }

  double orthonormality(const SmallMotions& motions) const {
    double greatest = 0;
    Eigen::VectorXd moved;
    for (std::size_t i = 0; i < found_.modes.size(); ++i) {
      motions.mass_times(found_.modes[i].shape, moved);
      for (std::size_t j = 0; j <= i; ++j)
        greatest = std::max(greatest, std::abs(found_.modes[j].shape.dot(moved) - (i == j ? 1 : 0)));
    }
    return greatest;
  }

  Dynamics& dynamics_;
  int count_;
  State rest_;
  Vibrations found_;
  StepResult conclusion_;
};

}  // namespace

MethodEntry modes_entry() {
  MethodInfo info;
  info.name = "modes";
  info.summary = "natural frequencies and shapes of small vibrations about an equilibrium";
  info.source =
      "Lanczos's method in blocks: Golub and Underwood 1977, Parlett 1998; with damping or spin "
      "Newton's iteration: Güttel and Tisseur 2017";
  info.order = "–";
  info.conserves = "nothing";
  info.use = "at which frequencies a cable vibrates, and whether it would stay where it rests";
  info.family = MethodFamily::modal;
  info.implicit = true;
  info.dynamic = false;
  info.timeless = true;
  info.spins = true;
  info.cost = {30000, 5000};
  info.parameters = {
      {.name = "count",
       .meaning = "how many modes, those of the lowest frequencies",
       .minimum = 1,
       .maximum = 500,
       .fallback = 10,
       .whole = true},
      {.name = "about",
       .meaning = "where the cable rests under the loads at the end of [time], or as it starts",
       .maximum = 1,
       .whole = true,
       .words = {"equilibrium", "start"}}};
  return {info, made<Modes>};
}

}  // namespace plumb
