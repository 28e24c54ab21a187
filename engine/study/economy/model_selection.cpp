#include "engine/study/economy/model_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/integrate/method_info.h"
#include "engine/study/economy/candidates.h"
#include "engine/study/reference/trajectory_divergence.h"

namespace plumb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Meshes of the full model, each twice as fine as the one before.
constexpr int coarsest_mesh = 1, finest_mesh = 256;
/// Meshes below this are too coarse to tell anything by how they agree.
constexpr int telling = 4;

/// Greatest value up to each frame; what is not a number is without end.
std::vector<double> so_far(std::vector<double> values) {
  for (double& value : values)
    if (std::isnan(value)) value = infinity;
  for (std::size_t k = 1; k < values.size(); ++k) values[k] = std::max(values[k], values[k - 1]);
  return values;
}

double last(const std::vector<double>& values) {
  return values.empty() ? infinity : values.back();
}

/// The error of the finest of three meshes by its distances to the two others, and by which ratio errors
/// fall from mesh to mesh: with that ratio q the distances are as q + 1 to 1. More than order 2 is not
/// believed, and of less than order 0.4 the distance itself counts three times.
struct OwnError {
  double error;
  double ratio;
};
OwnError own_error(double to_coarsest, double to_coarser) {
  constexpr double least = 4.0 / 3, greatest = 4;
  if (!std::isfinite(to_coarser)) return {infinity, -1};
  if (to_coarser <= 0) return {0, greatest};
  const double ratio = to_coarsest / to_coarser - 1;
  const double believed = std::isfinite(ratio) ? std::clamp(ratio, least, greatest) : least;
  return {to_coarser / (believed - 1), ratio};
}

class Search {
 public:
  Search(const Case& spec, const MakeGauge& make_gauge)
      : spec_(spec), make_gauge_(make_gauge), safe_(safe_candidate(spec)) {
    safe_.work = safe_work(spec);
    result_.tolerance = spec.scene.tolerance;
    result_.safe_work = safe_.work;
    if (spec.cable.model == CableModel::cable) result_.case_elements = spec.cable.elements;
  }

  Economy result() {
    const auto started = std::chrono::steady_clock::now();
    if (cannot_be_known()) {
      choose_safe();
    } else {
      refine();
      try_own_mesh();
      climb();
      settle();
    }
    result_.search_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return std::move(result_);
  }

 private:
  struct Member {
    TriedCandidate tried;
    Trajectory trajectory;
    std::vector<double> distances;  // to the finest, so far, a frame each
  };

  bool can_afford(const Candidate& candidate) const {
    return result_.search_work + candidate.work <= result_.safe_work;
  }

  Member run(const Candidate& candidate) {
    result_.search_work += candidate.work;
    Member member;
    member.tried.candidate = candidate;
    member.trajectory = integrate(with_candidate(spec_, candidate));
    member.tried.outcome = member.trajectory.outcome;
    member.tried.message = member.trajectory.message;
    member.tried.seconds = member.trajectory.processor_seconds;
    return member;
  }

  static bool completed(const Member& member) { return member.tried.outcome == Outcome::completed; }

  /// True where no mesh would settle what the picture shows: the cable stays where it is for want of a
  /// disturbance, or neighbours that nobody could tell from one another part before the end. Says so.
  bool cannot_be_known() {
    constexpr int elements = 8;
    constexpr double share_of_length = 0.1;
    const Candidate follower = cable_candidate(spec_, elements);
    constexpr double evaluations = 2 * 12;  // two motions, steps of order 8
    if (evaluations * follower.work > result_.safe_work) return false;
    result_.search_work += evaluations * follower.work;
    const Case followed = with_candidate(spec_, follower);
    unstable_ = integrate(followed).remark();
    if (!unstable_.empty()) {
      say_what_is_uncertain();
      return true;
    }
    const TrajectoryDivergence parted = divergence(followed, 0, share_of_length * spec_.cable.length);
    if (parted.times.empty() || parted.beyond_end) return false;
    result_.uncertain =
        fmt::format("where the cable is after {:.3g} s: the motion is beyond its predictability horizon: {}",
                    parted.horizon, parted.in_words);
    return true;
  }

  /// The full model on finer and finer meshes until one holds, and then once more: that proves it, and makes
  /// estimates of others sharper.
  void refine() {
    bool held = false;
    for (int elements = coarsest_mesh; elements <= finest_mesh; elements *= 2) {
      bool done = false;
      for (const double share : {1.0, 0.5, 0.25}) {
        const Candidate candidate = cable_candidate(spec_, elements, share);
        if (!can_afford(candidate)) {
          out_of_budget_ = !held;
          return;
        }
        spine_.push_back(run(candidate));
        done = completed(spine_.back());
        if (done) break;
      }
      if (!done || elements < telling) continue;
      const bool holds_now = estimate_spine();
      if (sees_nothing_) return;
      if (held && holds_now) return;
      held = holds_now;
    }
  }

  /// Holds all that was run of the full model against the finest. True where one of them holds.
  bool estimate_spine() {
    std::vector<Member*> whole;
    for (Member& member : spine_)
      if (completed(member)) whole.push_back(&member);
    if (whole.size() < 3) return false;
    finest_ = whole.back();
    gauge_ = make_gauge_(finest_->trajectory);
    for (Member* member : whole) member->distances = so_far(gauge_(member->trajectory));
    sees_nothing_ = finest_->distances.empty();
    if (sees_nothing_) return false;
    const std::vector<double>& coarsest_of_three = whole[whole.size() - 3]->distances;
    const std::vector<double>& coarser = whole[whole.size() - 2]->distances;
    own_.resize(coarser.size());
    for (std::size_t k = 0; k < own_.size(); ++k) own_[k] = own_error(coarsest_of_three[k], coarser[k]).error;
    own_ = so_far(std::move(own_));
    result_.finest = in_words(finest_->tried.candidate);
    result_.finest_error = last(own_);
    result_.observed_ratio = own_error(last(coarsest_of_three), last(coarser)).ratio;
    bool any = false;
    for (Member* member : whole) {
      estimate(*member);
      any = any || holds(member->tried);
    }
    return any;
  }

  void estimate(Member& member) const {
    // One that has not every frame, or none, is not estimated.
    if (!completed(member) || finest_ == nullptr || own_.empty() || member.distances.size() != own_.size())
      return;
    double estimate = 0, until = 0;
    for (std::size_t k = 0; k < own_.size(); ++k) {
      estimate = member.distances[k] + own_[k];
      if (economy_safety * estimate <= result_.tolerance)
        until = std::min(static_cast<double>(k) / spec_.scene.frame_rate, spec_.time.end);
    }
    member.tried.estimate = estimate;
    member.tried.certain_until = until;
  }

  bool holds(const TriedCandidate& tried) const {
    return tried.outcome == Outcome::completed && tried.estimate >= 0 &&
           economy_safety * tried.estimate <= result_.tolerance;
  }

  bool is_known(const Candidate& candidate) const {
    const auto same = [&](const Member& member) {
      return member.tried.candidate.cable == candidate.cable &&
             member.tried.candidate.method == candidate.method;
    };
    return std::any_of(spine_.begin(), spine_.end(), same) ||
           std::any_of(climbed_.begin(), climbed_.end(), same);
  }

  /// Pixels.
  double greatest_estimate() const { return result_.tolerance / economy_safety; }

  bool is_full(const CableSpec& cable) const {
    return cable.model == CableModel::cable && cable.quadrature == spec_.cable.quadrature &&
           cable.second_moment == spec_.cable.second_moment;
  }

  /// The tried candidates that are like one, in the order in which they were tried.
  template <class Alike>
  std::vector<const TriedCandidate*> tried_like(const Alike& alike) const {
    std::vector<const TriedCandidate*> found;
    for (const std::deque<Member>* members : {&spine_, &climbed_})
      for (const Member& member : *members)
        if (alike(member.tried.candidate)) found.push_back(&member.tried);
    return found;
  }

  /// The full model's coarsest mesh that holds; infinite where none does.
  double coarsest_holding() const {
    double elements = infinity;
    for (const Member& member : spine_)
      if (holds(member.tried)) elements = std::min<double>(elements, member.tried.candidate.cable.elements);
    return elements;
  }

  /// What need not be run, as what was run tells: meshes coarser than one that failed, steps that failed on
  /// another mesh or that are not what the error is from, and models that do not get better with their mesh.
  bool is_hopeless(const Candidate& candidate) const {
    constexpr double gain = 0.7;  // of the estimate, that is still a gain
    const CableSpec& cable = candidate.cable;
    if (cable.model == CableModel::rigid) return false;
    if (cable.model == CableModel::chain || cable.second_moment != spec_.cable.second_moment) {
      const auto alike = tried_like([&](const Candidate& other) {
        return other.cable.model == cable.model && other.cable.second_moment == cable.second_moment;
      });
      if (alike.size() < 3) return false;
      const double before = alike[alike.size() - 3]->estimate, last = alike.back()->estimate;
      return last > 2 * greatest_estimate() && last > gain * before;
    }
    const double needed = coarsest_holding();
    if (!is_full(cable)) return 4 * cable.elements < needed;
    // Half of the mesh that is needed has failed; with a shorter step it may do.
    if (2 * cable.elements < needed) return true;
    if (2 * cable.elements == needed && !is_leapfrog(candidate)) return true;
    if (!is_leapfrog(candidate)) return !has_promise(*candidate.method.step, candidate.method.name);
    // A shorter step than stability asks for.
    const auto longer = tried_like([&](const Candidate& other) {
      return other.cable == cable && other.method.name == candidate.method.name &&
             *other.method.step > *candidate.method.step;
    });
    return longer.size() >= 2 && longer.back()->estimate > gain * longer[longer.size() - 2]->estimate;
  }

  /// False where this step, or a shorter one, was tried on any mesh and was off by more than a finer mesh
  /// could mend.
  bool has_promise(double step, const std::string& method) const {
    for (const TriedCandidate* tried : tried_like([&](const Candidate& other) {
           return other.method.name == method && *other.method.step <= step;
         }))
      if (tried->outcome != Outcome::completed || tried->estimate > 2 * greatest_estimate()) return false;
    return true;
  }

  void try_candidate(const Candidate& candidate) {
    Member member = run(candidate);
    if (completed(member)) member.distances = so_far(gauge_(member.trajectory));
    estimate(member);
    climbed_.push_back(std::move(member));
  }

  /// The mesh that the case names, so that it can be said how far off that is.
  void try_own_mesh() {
    if (finest_ == nullptr || spec_.cable.model != CableModel::cable) return;
    const Candidate own = cable_candidate(spec_, spec_.cable.elements);
    if (!is_known(own) && own.work < finest_->tried.candidate.work && can_afford(own)) try_candidate(own);
  }

  /// From the cheapest candidate to the first that holds.
  void climb() {
    if (finest_ == nullptr || sees_nothing_) return;
    double limit = infinity;
    for (const Member& member : spine_)
      if (holds(member.tried)) limit = std::min(limit, member.tried.candidate.work);
    // Without one that holds there is still the rod, and what a chain is good for.
    if (limit == infinity) limit = finest_->tried.candidate.work;
    for (const Candidate& candidate : all_candidates(spec_, limit)) {
      if (is_known(candidate) || is_hopeless(candidate)) continue;
      if (!can_afford(candidate)) {
        out_of_budget_ = true;
        return;
      }
      try_candidate(candidate);
      if (holds(climbed_.back().tried)) return;
    }
  }

  /// Puts all that was tried in the order of cost, and chooses.
  void settle() {
    std::vector<Member*> all;
    for (std::deque<Member>* members : {&spine_, &climbed_})
      for (Member& member : *members) all.push_back(&member);
    std::stable_sort(all.begin(), all.end(), [](const Member* a, const Member* b) {
      return a->tried.candidate.work < b->tried.candidate.work;
    });
    for (const Member* member : all)
      if (unstable_.empty()) unstable_ = member->trajectory.remark();
    // What keeps to a line for want of a disturbance proves nothing.
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Member* m) { return unstable_.empty() && holds(m->tried); });
    result_.holds = found != all.end();
    const Member* chosen = result_.holds ? *found : finest_;
    if (result_.holds) share_out(*chosen);
    for (Member* member : all) {
      if (member == chosen) result_.chosen = static_cast<int>(result_.tried.size());
      member->tried.why = why(*member, member == chosen);
      result_.tried.push_back(member->tried);
    }
    if (result_.holds) return;
    if (out_of_budget_ || chosen == nullptr || sees_nothing_) choose_safe();
    say_what_is_uncertain();
  }

  /// How much of the chosen candidate's error its step is guilty of: that of half the step, by order 2.
  void share_out(const Member& chosen) {
    Candidate half = chosen.tried.candidate;
    if (!is_leapfrog(half)) return;
    *half.method.step /= 2;
    half.work *= 2;
    if (!can_afford(half)) return;
    const Member finer = run(half);
    if (!completed(finer)) return;
    const PictureErrors gauge = make_gauge_(finer.trajectory);
    result_.time_share = 4.0 / 3 * last(so_far(gauge(chosen.trajectory)));
  }

  std::string why(const Member& member, bool chosen) const {
    const TriedCandidate& tried = member.tried;
    if (tried.outcome != Outcome::completed) return fmt::format("left: {}", word(tried.outcome));
    if (tried.estimate < 0) return "left: too coarse to tell its error";
    const std::string times = fmt::format("{:g} × {:.3g} px", economy_safety, tried.estimate);
    if (holds(tried))
      return fmt::format("{}: {} is within {:g} px", chosen ? "taken" : "holds, but dearer", times,
                         result_.tolerance);
    return fmt::format("left: {} is more than {:g} px", times, result_.tolerance);
  }

  void choose_safe() {
    TriedCandidate safe;
    safe.candidate = safe_;
    safe.why = out_of_budget_       ? "taken unproven: the search would cost more than this run"
               : sees_nothing_      ? "taken unproven: nothing of the cable is in the picture"
               : !unstable_.empty() ? "taken unproven: the start is unstable"
               : !result_.uncertain.empty()
                   ? "taken unproven: neighbouring motions part before the end"
                   : "taken unproven: no three meshes of the full model came to their end";
    result_.chosen = static_cast<int>(result_.tried.size());
    result_.tried.push_back(std::move(safe));
  }

  void say_what_is_uncertain() {
    const double until = finest_ != nullptr ? finest_->tried.certain_until : 0;
    const std::string where =
        until > 0 ? fmt::format("where the cable is after {:.3g} s", until) : "where the cable is";
    if (sees_nothing_) {
      result_.uncertain = "what the picture shows: the cable is never in it, which proves nothing";
      return;
    }
    if (!unstable_.empty()) {
      result_.uncertain = where + ": " + unstable_ + ". Nothing is proven without an imperfection";
      return;
    }
    if (out_of_budget_)
      result_.uncertain = fmt::format(
          "{} within {:g} px: to tell it would cost more than one run at the safe default, which was taken",
          where, result_.tolerance);
    else if (finest_ == nullptr)
      result_.uncertain = where + ": no three meshes of the full model came to their end";
    else
      result_.uncertain = fmt::format("{} within {:g} px: meshes of up to {} elements do not agree on it",
                                      where, result_.tolerance, finest_->tried.candidate.cable.elements);
  }

  const Case& spec_;
  const MakeGauge& make_gauge_;
  Candidate safe_;
  Economy result_;
  std::deque<Member> spine_;    // the full model, mesh by mesh
  std::deque<Member> climbed_;  // the candidates below
  Member* finest_ = nullptr;
  PictureErrors gauge_;
  std::vector<double> own_;  // error of the finest, so far, a frame each
  bool out_of_budget_ = false;
  bool sees_nothing_ = false;  // of the cable, in any frame
  std::string unstable_;       // remark of a motion that stays where it is by symmetry; empty: none does
};

}  // namespace

Economy choose_candidate(const Case& spec, const MakeGauge& make_gauge) {
  if (const MethodInfo* info = find_method(spec.method.name); info != nullptr && !info->dynamic)
    throw InputError(
        fmt::format("method.name = \"{}\": nothing moves, so that there is no scene to compute "
                    "with less",
                    spec.method.name));
  if (spec.cable.model != CableModel::cable)
    throw InputError(
        fmt::format("cable.model = \"{}\": what a scene needs is told by the full model, \"cable\"",
                    word(spec.cable.model)));
  return Search(spec, make_gauge).result();
}

}  // namespace plumb
