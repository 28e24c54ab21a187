#include "engine/integrate/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/linear_stability.h"
#include "engine/integrate/method.h"
#include "engine/integrate/method_roles.h"
#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"

namespace plumb {
namespace {

/// The greatest number of three digits that is not above x.
double three_digits_below(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  // What is three digits already must not lose one to round-off.
  constexpr double round_off = 1e-9;
  return std::floor(x / unit * (1 + round_off)) * unit;
}

/// "0.00104 s".
std::string seconds_below(double x) {
  return fmt::format("{:.3g} s", three_digits_below(x));
}

/// ω of the fastest vibration of the states that can be believed: the start, and outputs before the energy
/// went astray.
double greatest_frequency(const Cable& cable, const State& start, const Trajectory& run) {
  constexpr double energy_share = 0.01;
  constexpr int most_states = 20, most_elements = 65536;  // looked at, in all
  double greatest = fastest_vibration(cable, start.q).frequency;
  std::size_t believed = 0;
  const double allowed = energy_share * run.kinetic_scale();
  while (believed < run.q.size() &&
         std::abs(run.energies[believed].total() - run.energies.front().total()) <= allowed)
    ++believed;
  const int states = std::clamp(most_elements / cable.elements(), 1, most_states);
  const std::size_t stride = std::max<std::size_t>(1, believed / static_cast<std::size_t>(states));
  // The last comes first; where there is time for one only, it is that.
  for (std::size_t k = believed; k > 0; k = k > stride ? k - stride : 0)
    greatest = std::max(greatest, fastest_vibration(cable, run.q[k - 1]).frequency);
  return greatest;
}

bool keeps_every_vibration(const MethodSpec& method) {
  constexpr double fast = 10, round_off = 1e-9;
  const auto radius = amplification(method, fast);
  return radius && std::abs(*radius - 1) <= round_off;
}

class Adviser {
 public:
  Adviser(const Cable& cable, const State& start, const Trajectory& run, const MethodSpec& method,
          const Attempt& attempt)
      : cable_(cable),
        start_(start),
        run_(run),
        method_(method),
        attempt_(attempt),
        info_(*find_method(method.name)),
        limit_(stability_limit(method)) {}

  std::string on(Outcome outcome) const {
    if (outcome == Outcome::unstable_equilibrium)
      return std::string(info_.timeless ? "" : "follow = \"stable\", ") +
             "a small force across that says to which side the cable gives way, or a smaller load";
    if (!info_.dynamic && outcome >= Outcome::unstable && outcome != Outcome::out_of_time)
      return !run_.times.empty() && run_.equilibria.path.empty()
                 ? "supports or a bending stiffness that hold the unloaded cable, or fewer elements where "
                   "the "
                   "mesh is too fine"
                 : "a smaller load, or more elements, but not so many that round-off hides the path";
    if (attempt_ && outcome >= Outcome::unstable && outcome <= Outcome::singular) return tried(outcome);
    switch (outcome) {
      case Outcome::unstable:
      case Outcome::diverged:
        return on_growth();
      case Outcome::no_convergence:
        return on_no_convergence();
      case Outcome::singular:
        return on_singular();
      case Outcome::out_of_time:
        return on_out_of_time();
      case Outcome::not_run:
      case Outcome::completed:
      case Outcome::accurate:
      case Outcome::inaccurate:
      case Outcome::unstable_equilibrium:
        break;
    }
    return "";
  }

 private:
  struct Candidate {
    std::string words;
    MethodSpec method;
    /// Must run as well, as what is below a step that serves does not always.
    std::optional<double> second_step = {};
    /// Of a series that is tried one after another, what has been tried with this one: "steps down to",
    /// before the setting; empty: of no series.
    std::string series = {};
    std::string setting = {};
  };

  /// The first candidate that runs; where none does, what was tried.
  std::string tried(Outcome outcome) const {
    std::vector<Candidate> in_vain;
    for (Candidate& candidate : candidates(outcome)) {
      std::string reached = attempt_(candidate.method);
      if (!reached.empty() && candidate.second_step) {
        candidate.method.step = candidate.second_step;
        reached = attempt_(candidate.method);
      }
      if (!reached.empty())
        return fmt::format("{} (tried {}){}", candidate.words, reached,
                           grows_beyond_a_step() ? ", or an implicit method" : "");
      // The last of a series stands for all.
      if (!in_vain.empty() && !candidate.series.empty() && in_vain.back().series == candidate.series)
        in_vain.pop_back();
      in_vain.push_back(std::move(candidate));
    }
    std::string names;
    for (const Candidate& candidate : in_vain)
      names += (names.empty() ? "" : ", ") +
               (candidate.series.empty() ? candidate.words : candidate.series + " " + candidate.setting);
    return fmt::format("{}; tried in vain: {}",
                       outcome == Outcome::singular ? "more elements, or less compression"
                                                    : "more elements, or another method",
                       names);
  }

  std::vector<Candidate> candidates(Outcome outcome) const {
    std::vector<Candidate> result;
    for (const MethodParameter& parameter : info_.parameters)
      if (parameter.name == "newton_iterations" &&
          method_.parameters.at(parameter.name) < parameter.fallback) {
        result.push_back(
            {fmt::format("newton_iterations of {:g} as by default", parameter.fallback), method_});
        result.back().method.parameters[parameter.name] = parameter.fallback;
      }
    if (method_.step)
      add_steps(result);
    else
      add_tolerances(outcome, result);
    add_methods(result);
    return result;
  }

  void add_steps(std::vector<Candidate>& result) const {
    constexpr int most_halvings = 7;
    // Steps below the one that is named must serve, and not it itself.
    constexpr double below = 0.95, far_below = 0.7;
    double step = 0.5 * *method_.step;
    if (grows_beyond_a_step())
      if (const double longest = longest_step(); longest < *method_.step) step = longest;
    for (int halvings = 0; halvings < most_halvings; ++halvings, step *= 0.5) {
      const std::string setting = seconds_below(step);
      const double named = three_digits_below(step);
      result.push_back({"a step below " + setting, method_, far_below * named, "steps down to", setting});
      *result.back().method.step = below * named;
    }
  }

  void add_tolerances(Outcome outcome, std::vector<Candidate>& result) const {
    constexpr double loosest = 1e-2, tightest = 1e-12;
    const auto add = [&](double factor) {
      for (double rtol = *method_.rtol * factor; rtol <= loosest && rtol >= tightest; rtol *= factor) {
        const std::string setting = fmt::format("{:.1g}", rtol);
        result.push_back({(*method_.rtol == *method_.atol ? "rtol = " : "rtol = atol = ") + setting,
                          method_,
                          {},
                          factor > 1 ? "rtol up to" : "rtol down to",
                          setting});
        // As it is written.
        result.back().method.rtol = result.back().method.atol = std::stod(setting);
      }
    };
    const double first = outcome == Outcome::no_convergence ? 10 : 0.1;
    add(first);
    add(1 / first);
  }

  /// Others, with the same step or tolerances of their own.
  void add_methods(std::vector<Candidate>& result) const {
    const auto add = [&](const MethodInfo& other, bool by_step) {
      if (other.name == method_.name || !takes(other, cable_)) return;
      MethodSpec with = plain_method(other);
      if (by_step)
        with.step = method_.step;
      else
        with.rtol = with.atol = other.rtol;
      result.push_back({other.name + (by_step ? fmt::format(" with a step of {:g} s", *with.step)
                                              : fmt::format(" with rtol = {:g}", *with.rtol)),
                        with});
    };
    if (method_.step) {
      add(energy_keeping(), true);
      add(usual_implicit(), true);
    }
    add(takes(accurate_explicit(), cable_) ? accurate_explicit() : embedded_explicit(), false);
    add(usual_implicit(), false);
  }

  bool grows_beyond_a_step() const { return method_.step && limit_ && *limit_ > 0 && std::isfinite(*limit_); }

  /// s; infinite where nothing vibrates.
  double longest_step() const { return *limit_ / greatest_frequency(cable_, start_, run_); }

  std::string half_the_step() const { return "a step below " + seconds_below(0.5 * *method_.step); }

  std::string on_growth() const {
    if (!method_.step) return "tighter tolerances";
    if (limit_ && *limit_ == 0)
      return "another order or another method: with this one some vibrations grow at every step";
    if (grows_beyond_a_step()) {
      const double longest = longest_step();
      return (*method_.step > longest ? "a step below " + seconds_below(longest) : half_the_step()) +
             ", or an implicit method";
    }
    if (info_.keeps_energy) return half_the_step();
    if (keeps_every_vibration(method_))
      return fmt::format("{}{} with {}, or {}",
                         takes(energy_keeping(), cable_) ? energy_keeping().name + ", " : "",
                         usual_implicit().name, usual_implicit().damps_with, half_the_step());
    return half_the_step() + or_energy_keeping();
  }

  std::string or_energy_keeping() const {
    return takes(energy_keeping(), cable_) ? ", or " + energy_keeping().name : "";
  }

  std::string on_no_convergence() const {
    if (method_.step && grows_beyond_a_step()) return on_growth();
    if (method_.step) {
      std::string text;
      for (const MethodParameter& parameter : info_.parameters)
        if (parameter.name == "newton_iterations" &&
            method_.parameters.at(parameter.name) < parameter.fallback)
          text += fmt::format("newton_iterations of {:g} as by default, ", parameter.fallback);
      text += half_the_step();
      if (info_.takes_tolerances) text += ", rtol in the place of a step so that it can be cut";
      if (!info_.keeps_energy) text += or_energy_keeping();
      return text;
    }
    return fmt::format("looser tolerances than rtol = {:g} and atol = {:g}, more elements, or another method",
                       *method_.rtol, *method_.atol);
  }

  std::string on_singular() const {
    // What an explicit method lets grow collapses a slope before it is anything else.
    if (grows_beyond_a_step() && *method_.step > longest_step()) return on_growth();
    std::string text = "more elements, less compression";
    if (cable_.element().bending_stiffness() == 0)
      text += ", a bending stiffness (cable.second_moment above 0)";
    return text + (method_.step ? ", or " + half_the_step() : ", or tighter tolerances");
  }

  std::string on_out_of_time() const {
    if (!method_.step) return "looser tolerances, fewer elements, or more time";
    if (grows_beyond_a_step()) {
      const double longest = longest_step();
      if (*method_.step < longest)
        return "a longer step, of up to " + seconds_below(longest) + ", an implicit method, or more time";
      return "an implicit method, fewer elements, or more time";
    }
    return "a longer step, fewer elements, or more time";
  }

  const Cable& cable_;
  const State& start_;
  const Trajectory& run_;
  const MethodSpec& method_;
  const Attempt& attempt_;
  const MethodInfo& info_;
  std::optional<double> limit_;
};

}  // namespace

std::string advice(const Cable& cable, const State& start, const Trajectory& run, const MethodSpec& method,
                   Outcome outcome, const Attempt& attempt) {
  return Adviser(cable, start, run, method, attempt).on(outcome);
}

}  // namespace plumb
