#include "engine/study/economy/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/integrate/integrate.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/load.h"
#include "engine/model/straight_frequency.h"
#include "engine/model/supports.h"

namespace plumb {
namespace {

/// Time of a step, ns, as measured on one machine: what is the same each step, and what each element adds.
/// Only their ratios matter.
struct StepWork {
  double fixed;
  double element;

  double of(int elements) const { return fixed + element * elements; }
};
constexpr StepWork leapfrog_cable{150, 25}, leapfrog_chain{80, 36}, rigid_step{75, 10},
    implicit_step{1000, 560};
constexpr StepWork safe_step{400, 600};
constexpr double safe_phase = 2.5;  // ωh of its steps, of the fastest vibration, about

/// Of the leapfrog's limit of stability. A cable that is stretched vibrates faster than the straight one.
constexpr double share_of_limit = 0.65;

/// A number that its text of six digits gives exactly.
double rounded(double value) {
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

MethodSpec with_step(const MethodInfo& info, double step) {
  MethodSpec method = plain_method(info);
  method.step = step;
  return method;
}

double steps(const Case& spec, const Candidate& candidate) {
  return std::ceil(spec.time.end / *candidate.method.step);
}

Candidate leapfrog(const Case& spec, CableSpec cable, double share_of_step) {
  const bool chain = cable.model == CableModel::chain;
  const double link = cable.length / cable.elements;
  const double frequency =
      chain ? 2 * std::sqrt(cable.youngs_modulus / cable.density) / link : straight_frequency(cable);
  const double longest = scene_output_interval(spec) / 2;
  Candidate candidate{cable,
                      with_step(usual_explicit(),
                                rounded(std::min(longest, share_of_limit * 2 / frequency) * share_of_step))};
  candidate.work = steps(spec, candidate) * (chain ? leapfrog_chain : leapfrog_cable).of(cable.elements);
  return candidate;
}

CableSpec meshed(const Case& spec, int elements) {
  CableSpec cable = spec.cable;
  cable.model = CableModel::cable;
  cable.elements = elements;
  return cable;
}

bool has_rigid_rod(const Case& spec) {
  const ColorField field = spec.scene.color_by;
  const Hold first = hold_of(spec.supports.first), last = hold_of(spec.supports.last);
  return first.position && !first.direction && last.none() && !spec.supports.move() &&
         spec.start.slope_rates == SlopeRates::rigid && spec.start.axial_speed == 0 &&
         spec.start.stretch == 1 && spec.damping.material == 0 &&
         (field == ColorField::none || field == ColorField::speed) &&
         std::all_of(spec.probes.begin(), spec.probes.end(),
                     [](const ProbeSpec& probe) { return is_vector(probe.quantity); });
}

/// A chain has no bending to show, and none for a moment.
bool has_chain(const Case& spec) {
  return !hold_of(spec.supports.first).direction && !hold_of(spec.supports.last).direction &&
         std::none_of(spec.loads.applied.begin(), spec.loads.applied.end(),
                      [](const LoadSpec& load) { return load.kind == LoadKind::moment; }) &&
         spec.start.slope_rates == SlopeRates::rigid && spec.scene.color_by != ColorField::curvature &&
         spec.scene.color_by != ColorField::bending_moment;
}

Candidate rigid_candidate(const Case& spec) {
  constexpr double phase = 0.05;  // turned a step: a method of order 4 is off by some 1e-8 of that
  CableSpec cable = meshed(spec, 1);
  cable.model = CableModel::rigid;
  cable.second_moment = 0;
  cable.quadrature = QuadratureRule::full;
  cable.strain = StrainModel::green_geometric;
  Case rod = spec;
  rod.cable = cable;
  const LoadSum loads(loads_of(rod));
  const double mass = cable.density * cable.area * cable.length;
  double pull = 1.5 * loads.per_mass().norm() / cable.length;
  for (const NodeForce& on : loads.on_nodes()) {
    const Vec3 force(on.force), moment(on.force + 3);
    pull += 3 * (force.norm() * on.node + moment.norm() / cable.length) / (mass * cable.length);
  }
  const double fastest = std::sqrt(spec.start.angular_velocity.squaredNorm() + 4 * pull);
  const double longest = scene_output_interval(spec);
  Candidate candidate{cable, with_step(rigid_rod_method(),
                                       rounded(fastest > 0 ? std::min(longest, phase / fastest) : longest))};
  candidate.work = steps(spec, candidate) * rigid_step.of(1);
  return candidate;
}

void add_implicit(const Case& spec, int elements, double below, std::vector<Candidate>& candidates) {
  constexpr int most_halvings = 7;
  double step = scene_output_interval(spec);
  for (int k = 0; k <= most_halvings; ++k, step /= 2) {
    Candidate candidate{meshed(spec, elements), with_step(usual_implicit(), step)};
    candidate.work = steps(spec, candidate) * implicit_step.of(elements);
    if (candidate.work >= below) return;
    candidates.push_back(std::move(candidate));
  }
}

}  // namespace

double scene_output_interval(const Case& spec) {
  const double frames = 1 / spec.scene.frame_rate;
  if (spec.references.empty() && spec.figures.empty()) return std::min(frames, spec.time.end);
  // As many to a frame as the case has outputs.
  return std::min(frames / std::ceil(frames / spec.time.output_interval - 1e-9), spec.time.end);
}

Case with_candidate(const Case& spec, const Candidate& candidate) {
  Case result = spec;
  result.cable = candidate.cable;
  result.method = candidate.method;
  result.time.output_interval = scene_output_interval(spec) / outputs_of_a_frame;
  return result;
}

std::vector<std::string> candidate_overrides(const Case& spec, const Candidate& candidate) {
  std::vector<std::string> result{
      fmt::format("cable.model={}", word(candidate.cable.model)),
      fmt::format("cable.elements={}", candidate.cable.elements),
      fmt::format("time.output_interval={}", scene_output_interval(spec)),
  };
  if (candidate.cable.model == CableModel::cable) {
    result.push_back(fmt::format("cable.quadrature={}", word(candidate.cable.quadrature)));
    if (candidate.cable.second_moment != spec.cable.second_moment)
      result.push_back(fmt::format("cable.second_moment={}", candidate.cable.second_moment));
  }
  result.push_back(fmt::format("method.name={}", candidate.method.name));
  if (candidate.method.step) result.push_back(fmt::format("method.step={}", *candidate.method.step));
  if (candidate.method.rtol) result.push_back(fmt::format("method.rtol={}", *candidate.method.rtol));
  if (candidate.method.atol) result.push_back(fmt::format("method.atol={}", *candidate.method.atol));
  // All of them, as the file may have others for a method of the same name.
  for (const auto& [name, value] : candidate.method.parameters)
    result.push_back(fmt::format("method.{}={}", name, value));
  return result;
}

std::string in_words(const Candidate& candidate) {
  const CableSpec& cable = candidate.cable;
  const auto counted = [&](const char* one) {
    return fmt::format("{} {}{}", cable.elements, one, cable.elements == 1 ? "" : "s");
  };
  std::string text;
  if (cable.model == CableModel::rigid)
    text = "rigid rod";
  else if (cable.model == CableModel::chain)
    text = "chain of " + counted("link");
  else
    text = "cable of " + counted("element");
  if (cable.model == CableModel::cable) {
    if (cable.quadrature == QuadratureRule::reduced) text += ", reduced quadrature";
    if (cable.second_moment == 0) text += ", no bending";
  }
  text += ", " + candidate.method.name;
  if (candidate.method.step) text += fmt::format(" with step {:.3g} s", *candidate.method.step);
  if (candidate.method.rtol) text += fmt::format(" with rtol {:.3g}", *candidate.method.rtol);
  return text;
}

bool is_leapfrog(const Candidate& candidate) {
  return candidate.method.name == usual_explicit().name;
}

Candidate cable_candidate(const Case& spec, int elements, double share_of_step) {
  return leapfrog(spec, meshed(spec, elements), share_of_step);
}

std::vector<Candidate> all_candidates(const Case& spec, double limit) {
  std::vector<Candidate> candidates;
  const auto add = [&](Candidate candidate) {
    if (candidate.work < limit) candidates.push_back(std::move(candidate));
  };
  if (has_rigid_rod(spec)) add(rigid_candidate(spec));
  for (const int elements : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256}) {
    if (has_chain(spec) && elements > 1) {
      CableSpec chain = meshed(spec, elements);
      chain.model = CableModel::chain;
      chain.second_moment = 0;
      chain.quadrature = QuadratureRule::full;
      add(leapfrog(spec, chain, 1));
    }
    const CableSpec cable = meshed(spec, elements);
    for (const double share : {1.0, 0.5, 0.25}) add(leapfrog(spec, cable, share));
    if (cable.quadrature == QuadratureRule::full) {
      CableSpec reduced = cable;
      reduced.quadrature = QuadratureRule::reduced;
      add(leapfrog(spec, reduced, 1));
    }
    if (cable.second_moment > 0 && elements > 1) {
      CableSpec slack = cable;
      slack.second_moment = 0;
      // Of the same step there is nothing to be gained: the kernels bend a cable without stiffness as well.
      if (const Candidate candidate = leapfrog(spec, slack, 1);
          *candidate.method.step > 1.01 * *leapfrog(spec, cable, 1).method.step)
        add(candidate);
    }
    add_implicit(spec, elements, std::min(limit, leapfrog(spec, cable, 1).work), candidates);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.work < b.work; });
  return candidates;
}

Candidate safe_candidate(const Case& spec) {
  Candidate candidate{meshed(spec, safe_elements), plain_method(embedded_explicit())};
  candidate.method.rtol = candidate.method.atol = safe_tolerance;
  return candidate;
}

double safe_work(const Case& spec) {
  constexpr double steps_tried = 2000;
  Case beginning = with_candidate(spec, safe_candidate(spec));
  const double steps_a_second = straight_frequency(beginning.cable) / safe_phase;
  beginning.time.end = std::min(spec.time.end, steps_tried / steps_a_second);
  beginning.time.output_interval = beginning.time.end;
  const Trajectory tried = integrate(beginning);
  const double taken =
      static_cast<double>(tried.counters.steps + std::max(0L, tried.counters.rejected_steps));
  return (tried.end_time > 0 ? taken * spec.time.end / tried.end_time : spec.time.end * steps_a_second) *
         safe_step.of(safe_elements);
}

}  // namespace plumb
