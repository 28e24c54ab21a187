#include "engine/integrate/methods/equilibrium_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/interrupt.h"
#include "engine/integrate/methods/damped_motion.h"
#include "engine/integrate/methods/newton.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

constexpr double first_step = 0.02, longest_step = 0.1, shortest_step = 1e-9;
/// Largest error left of the points of the path, as a fraction of the length.
constexpr double path_tolerance = 1e-9;
/// Steps of the path, tried or taken, in a run.
constexpr long most_attempts = 20'000;
/// Corrections, where the mesh is so fine that round-off is near.
constexpr long most_corrections_of_fine = 600;
/// To which the load of a critical point is found, as a share of the whole load.
constexpr double critical_width = 1e-7;
/// Of the step, within which a limit point is found: its load is better than that by its square.
constexpr double limit_width = 1e-5;
/// Corrections that a step of a smooth path takes, at most.
constexpr int most_corrections = 7;
/// First step beyond a critical point.
constexpr double step_beyond = 1e-3;
/// Cosine of the angle by which the path may turn in a step.
constexpr double least_straightness = 0.9;
/// Of what the load moves at the start, beyond which corrections lead nowhere.
constexpr double most_round_off = 0.02;
/// The same, beyond which the sign of an eigenvalue that is not positive is round-off, and with it what asks
/// for steps shorter than this.
constexpr double most_round_off_of_sign = 1e-4, shortest_step_of_fine = 1e-6;
/// A path under a primary load that goes back is followed up to the opposite of the whole load.
constexpr double farthest_back = -1;

StepResult hidden_by_round_off() {
  return {
      Outcome::no_convergence,
      "the mesh is too fine: round-off, which grows with the third power of the number of elements, hides "
      "how the path goes on",
      -1};
}

}  // namespace

std::string mode_in_words(const CriticalPoint& point) {
  return fmt::format("that moves most at {:.3g} of the length, along ({:.3g}, {:.3g}, {:.3g})", point.at,
                     point.direction[0], point.direction[1], point.direction[2]);
}

std::string eigenvalues_in_words(int negative) {
  return negative < 0 ? "an eigenvalue that is not positive"
                      : fmt::format("{} negative eigenvalue{}", negative, negative == 1 ? "" : "s");
}

EquilibriumPath::EquilibriumPath(LoadedCable& loaded, Follow follow, int iterations)
    : loaded_(loaded), follow_(follow), iterations_(iterations), step_(first_step) {
  Node node;
  node.q = loaded.start();
  beginning_ = loaded.settle(node.q, 0, iterations);
  if (!beginning_.ok()) return;
  node.negative = loaded.negative_eigenvalues();
  if (const double share = loaded.share_of_round_off(node.q, loaded.load());
      !(share <= (node.negative == 0 ? most_round_off : most_round_off_of_sign))) {
    beginning_ = {Outcome::no_convergence,
                  fmt::format("the mesh is too fine: {:.2g} of what the load moves is round-off, which grows "
                              "with the third power of the number of elements",
                              share),
                  -1};
    return;
  }
  Eigen::VectorXd everywhere = Eigen::VectorXd::Zero(node.q.size());
  for (Eigen::Index at = 0; at < everywhere.size(); at += 6) everywhere.segment<3>(at).setOnes();
  loaded.cable().supports().apply(everywhere);
  is_fine_ = loaded.share_of_round_off(node.q, everywhere) > most_round_off_of_sign;
  if (node.negative != 0) {
    beginning_ = {Outcome::unstable_equilibrium, "the unloaded cable would not stay as it starts", -1};
    return;
  }
  set_direction(Eigen::VectorXd::Zero(node.q.size()), 1, node);
  start_ = node.q;
  append(std::move(node));
}

void EquilibriumPath::append(Node node) {
  points_.push_back({node.share, loaded_.displacement(node.q), node.negative, node.joined});
  nodes_.push_back(std::move(node));
}

bool EquilibriumPath::set_direction(const Eigen::VectorXd& dq, double d_share, Node& node) {
  by_load_ = loaded_.load();
  loaded_.solve(by_load_);
  const double length = std::sqrt(loaded_.dot(by_load_, by_load_) + 1);
  if (!std::isfinite(length)) return false;
  node.dq = by_load_ / length;
  node.d_share = 1 / length;
  if (loaded_.dot(dq, node.dq) + d_share * node.d_share < 0) {
    node.dq *= -1;
    node.d_share *= -1;
  }
  return true;
}

StepResult EquilibriumPath::correct(const Eigen::VectorXd& normal, double normal_share, double reach,
                                    Node& node, int& iterations) {
  const double l = loaded_.cable().element().length();
  // What is asked for is found from the path to the tolerance of the run.
  const double tolerance = std::max(loaded_.tolerance(), path_tolerance * loaded_.cable().length());
  const Eigen::VectorXd guess = node.q;
  const double guessed_share = node.share;
  CorrectionSize correction;
  double last = 0;
  if (const auto element = loaded_.residual(node.q, node.share, residual_))
    return LoadedCable::collapsed(*element);
  for (iterations = 0; iterations <= iterations_; ++iterations) {
    if (const auto at = loaded_.factor(node.q)) return loaded_.singular(*at);
    if (iterations > 0 && loaded_.has_converged(correction.metres, last, residual_, node.share, tolerance)) {
      // What round-off takes says nothing of the path.
      if (correction.metres > tolerance) iterations = std::min(iterations, most_corrections);
      return {};
    }
    last = iterations > 0 ? correction.metres : std::numeric_limits<double>::infinity();
    by_residual_ = residual_;
    by_load_ = loaded_.load();
    loaded_.solve(by_residual_);
    loaded_.solve(by_load_);
    ++loaded_.dynamics().counters.newton_iterations;
    const double along = loaded_.dot(normal, by_load_) + normal_share;
    const double d_share = -loaded_.dot(normal, by_residual_) / along;
    by_residual_ += d_share * by_load_;
    correction = correction_size(by_residual_, 1, l);
    if (!std::isfinite(d_share) || !std::isfinite(correction.metres)) break;
    if (iterations > 8 && correction.metres > tolerance && correction.metres > last) break;
    node.q += by_residual_;
    node.share += d_share;
    const double strayed =
        std::sqrt(std::pow(loaded_.norm(node.q - guess), 2) + std::pow(node.share - guessed_share, 2));
    if (!(strayed <= reach)) break;
    if (const auto element = loaded_.residual(node.q, node.share, residual_))
      return LoadedCable::collapsed(*element);
  }
  return not_converged(correction, tolerance, loaded_.cable().length());
}

EquilibriumPath::Attempt EquilibriumPath::attempt(const Node& from, double step, Node& to) {
  constexpr double most_correction = 0.5;  // of the step
  Attempt result;
  ++attempts_;
  to.q = from.q + step * from.dq;
  to.share = from.share + step * from.d_share;
  to.joined = true;
  result.failure = correct(from.dq, from.d_share, most_correction * step, to, result.iterations);
  if (!result.failure.ok()) return result;
  if (LoadedCable::is_reversed(from.q, to.q)) {
    result.failure = LoadedCable::collapsed(-1);
    return result;
  }
  to.negative = loaded_.negative_eigenvalues();
  if (!set_direction(from.dq, from.d_share, to)) return result;
  result.straightness = loaded_.dot(from.dq, to.dq) + from.d_share * to.d_share;
  // Along a path that stays stable the load does work.
  const bool goes_back = from.negative == 0 && to.negative == 0 && to.d_share < 0;
  // More corrections than a step of a smooth path takes, down to steps where round-off asks for them.
  const bool strays = result.iterations > most_corrections && step > 1e-6;
  result.ok = !strays && to.negative >= 0 && !goes_back && result.straightness >= least_straightness;
  if (!result.ok) result.failure = {Outcome::no_convergence, "the path turns too sharply to be followed", -1};
  return result;
}

StepResult EquilibriumPath::advance() {
  Node to;
  for (;;) {
    stop_if_interrupted();
    const Node& from = nodes_.back();
    if (is_fine_ && loaded_.dynamics().counters.newton_iterations > most_corrections_of_fine)
      return hidden_by_round_off();
    if (attempts_ > most_attempts)
      return {Outcome::no_convergence,
              fmt::format("the path of equilibria took more than {} steps", most_attempts), -1};
    Attempt tried = attempt(from, step_, to);
    if (!tried.ok) {
      good_ = 0;
      step_ *= 0.5;
      if (is_fine_ && step_ < shortest_step_of_fine) return hidden_by_round_off();
      if (step_ < shortest_step) {
        if (turn_off(tried.failure)) return {};
        return tried.failure;
      }
      continue;
    }
    if (to.negative != from.negative) {
      const bool turns = from.d_share * to.d_share < 0;
      const bool narrow = std::abs(to.share - from.share) <= critical_width &&
                          step_ <= (turns ? limit_width : critical_width);
      if (!narrow) {
        good_ = 0;
        step_ *= 0.5;
        continue;
      }
      // What changes sign may be round-off.
      if (is_fine_) return hidden_by_round_off();
      return pass(Node(from), to, step_);
    }
    if (to.share < farthest_back)
      return {Outcome::no_convergence, "the path of equilibria turns back and leads to no such load", -1};
    append(to);
    constexpr int few_iterations = 4;
    constexpr double straight = 0.98;
    if (++good_ > 1 && tried.iterations <= few_iterations && tried.straightness > straight)
      step_ = std::min(2 * step_, longest_step);
    return {};
  }
}

CriticalPoint& EquilibriumPath::note_critical(CriticalKind kind, const Node& before, const Node& after,
                                              const CriticalMode& mode, double share) {
  CriticalPoint point;
  point.kind = kind;
  point.load = share;
  point.displacement = loaded_.displacement(before.q);
  point.negative_before = before.negative;
  point.negative_after = after.negative;
  point.at = mode.at;
  point.direction = {mode.direction.x(), mode.direction.y(), mode.direction.z()};
  return critical_points_.emplace_back(std::move(point));
}

StepResult EquilibriumPath::pass(const Node& before, const Node& after, double step) {
  const bool turns = before.d_share * after.d_share < 0;
  // Of a parabola through both ends.
  const double way = turns ? step * before.d_share / (before.d_share - after.d_share) : 0;
  const double share = turns ? before.share + 0.5 * before.d_share * way : 0.5 * (before.share + after.share);
  if (const auto node = loaded_.factor(before.q)) return loaded_.singular(*node);
  const CriticalMode mode = critical_mode(loaded_);
  good_ = 0;
  step_ = step_beyond;
  CriticalPoint& point = note_critical(turns ? CriticalKind::limit_point : CriticalKind::bifurcation, before,
                                       after, mode, share);
  if (follow_ == Follow::primary || before.negative != 0) {
    point.what_followed = "along the same path";
    append(after);
    return {};
  }
  if (!turns && branch_off(before, mode, point.what_followed)) return {};
  StepResult rest = go_over(before, turns ? before.dq : mode.shape, point.what_followed);
  if (!rest.ok())
    rest.reason = fmt::format("a {} is at {:.6g} of the load, in the mode {}: {}", in_words(point.kind),
                              share, mode_in_words(point), rest.reason);
  return rest;
}

bool EquilibriumPath::branch_off(const Node& from, const CriticalMode& mode, std::string& what_followed) {
  for (const double way : {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}) {
    Node node;
    node.q = from.q + way * mode.shape;
    node.share = from.share;
    int iterations = 0;
    if (!correct(mode.shape, 0, 0.5 * way, node, iterations).ok()) continue;
    node.negative = loaded_.negative_eigenvalues();
    if (node.negative != 0 || node.share < from.share - critical_width) continue;
    if (!set_direction(mode.shape, 0, node) || node.d_share < 0) continue;
    what_followed = fmt::format(
        "onto the stable branch by the mode, to the side {}",
        mode.by_load ? "to which the load pushes" : "of its positive direction, both sides being alike");
    append(std::move(node));
    return true;
  }
  return false;
}

StepResult EquilibriumPath::go_over(const Node& from, const Eigen::VectorXd& kick,
                                    std::string& what_followed) {
  constexpr double push = 1e-2;
  // Damped motion would creep for thousands of steps.
  if (is_fine_) return hidden_by_round_off();
  StepResult rest;
  for (const double more : {0.0, 1e-6, 1e-4, 1e-2}) {
    Node node;
    node.q = from.q + push * kick / loaded_.norm(kick);
    node.share = from.share + more;
    rest = come_to_rest(loaded_, node.q, node.share);
    if (!rest.ok()) continue;
    // Back where it was.
    if (more == 0 && loaded_.norm(node.q - from.q) < 0.5 * push) continue;
    if (LoadedCable::is_reversed(from.q, node.q)) {
      rest = LoadedCable::collapsed(-1);
      continue;
    }
    node.joined = false;
    if (!set_direction(Eigen::VectorXd::Zero(node.q.size()), 1, node)) continue;
    what_followed = fmt::format(
        "no equilibrium is near: damped motion leads to another one, with a node {:.4g} m away, "
        "under {:.6g} of the load",
        greatest_displacement(node.q - from.q), node.share);
    append(std::move(node));
    return {};
  }
  what_followed = "no equilibrium is near, and damped motion leads to none";
  return {Outcome::no_convergence,
          "no equilibrium is near, and " + (rest.ok() ? "damped motion leads back" : rest.reason),
          rest.element};
}

bool EquilibriumPath::turn_off(StepResult& why) {
  const Node from = nodes_.back();
  if (follow_ == Follow::primary || from.negative != 0 || loaded_.factor(from.q)) return false;
  const CriticalMode mode = critical_mode(loaded_);
  good_ = 0;
  step_ = step_beyond;
  std::string what_followed;
  const bool branches = mode.gives_way && branch_off(from, mode, what_followed);
  if (!branches) {
    if (StepResult rest = go_over(from, mode.gives_way ? mode.shape : from.dq, what_followed); !rest.ok()) {
      why.reason += ": " + rest.reason;
      return false;
    }
  }
  if (mode.gives_way)
    note_critical(CriticalKind::bifurcation, from, from, mode, from.share).what_followed = what_followed;
  return true;
}

std::optional<std::size_t> EquilibriumPath::around(std::size_t first, double share) const {
  for (std::size_t k = first; k + 1 < nodes_.size(); ++k) {
    if (nodes_[k].share <= share && share <= nodes_[k + 1].share) return k;
  }
  return std::nullopt;
}

StepResult EquilibriumPath::locate(std::size_t first, double share, Found& found) {
  const std::optional<std::size_t> k = around(first, share);
  if (!k) return {Outcome::no_convergence, "the path of equilibria has not come to it", -1};
  const Node &a = nodes_[*k], &b = nodes_[*k + 1];
  found.share = share;
  const auto take = [&](const Eigen::VectorXd& q, int negative) {
    found.q = q;
    found.negative = negative;
    return StepResult{};
  };
  if (share == a.share) return take(a.q, a.negative);
  if (share == b.share) return take(b.q, b.negative);
  const double width = loaded_.norm(b.q - a.q) + std::abs(b.share - a.share);
  const auto settles = [&](const Eigen::VectorXd& guess) {
    Eigen::VectorXd q = guess;
    if (!loaded_.settle(q, share, iterations_).ok() || loaded_.norm(q - guess) > width) return false;
    const int negative = loaded_.negative_eigenvalues();
    if (negative != a.negative && negative != b.negative) return false;
    take(q, negative);
    return true;
  };
  const double part = (share - a.share) / (b.share - a.share);
  if (settles(a.q + part * (b.q - a.q))) return {};
  if (!b.joined && (settles(b.q) || settles(a.q))) return {};
  // Nearer on the path: by steps of half the way, until the load is met.
  Node from = a, to;
  double step = 0.5 * std::sqrt(std::pow(loaded_.norm(b.q - a.q), 2) + std::pow(b.share - a.share, 2));
  for (int halvings = 0; halvings < 60;) {
    const Attempt tried = attempt(from, step, to);
    if (!tried.ok || to.share > share) {
      if (tried.ok && settles(from.q + (share - from.share) / (to.share - from.share) * (to.q - from.q)))
        return {};
      step *= 0.5;
      ++halvings;
      continue;
    }
    from = to;
    if (settles(from.q)) return {};
  }
  return {Outcome::no_convergence, "the path of equilibria could not be resolved there", -1};
}

StepResult EquilibriumPath::reach(double share, Found& found) {
  while (!around(last_, share)) {
    if (!failure_.ok()) return failure_;
    if (StepResult result = advance(); !result.ok()) {
      failure_ = std::move(result);
      return failure_;
    }
  }
  // What comes before the equilibrium reached before is not asked for any more.
  nodes_.erase(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(last_));
  last_ = 0;
  StepResult result = locate(0, share, found);
  if (result.ok()) last_ = *around(0, share);
  return result;
}

StepResult EquilibriumPath::between(double share, Found& found) {
  return locate(0, share, found);
}

}  // namespace plumb
