#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/method_info.h"
#include "engine/integrate/trajectory.h"
#include "engine/run/provenance.h"
#include "engine/study/reference/reference_motion.h"

namespace plumb {

/// True for accurate and inaccurate: completed, with the energy bounded.
bool is_stable(Outcome outcome);

/// What a map of outcomes has beside the step.
enum class MapAxis { parameter, elements, duration };
/// "parameter", "elements", "duration".
std::string_view word(MapAxis);
inline std::array<MapAxis, 3> enum_values(MapAxis) {
  return {MapAxis::parameter, MapAxis::elements, MapAxis::duration};
}

/// One run of a map.
struct StabilityPoint {
  Outcome outcome = Outcome::not_run;  ///< `completed` only where no time after the start could be judged
  std::string message;                 ///< for a run that did not complete
  double end_time = -1;                ///< reached, s
  double error = -1;                   ///< greatest distance of a node to the reference, m; -1: not judged
  double judged_until = -1;            ///< s
  double energy_change = 0;            ///< last total energy minus the first, over the first kinetic energy
  long steps = -1;
  double seconds = -1;  ///< of the time loop, beside other runs: no measurement
};

/// Where a method is expected to fail, as a step in s; -1: not known, infinite: at no step.
struct PredictedLimit {
  double at_start = -1;  ///< from the fastest vibration of the start
  double at_worst = -1;  ///< from the fastest vibration seen along the reference
};

/// What a predicted limit rests on.
enum class LimitKind {
  none,         ///< no prediction: the method chooses its steps
  vibration,    ///< the fastest vibration grows beyond it
  contraction,  ///< Newton's iteration contracts no longer
  always,       ///< some vibration grows at every step
};
/// "none", "vibration", "contraction", "always".
std::string_view word(LimitKind);
inline std::array<LimitKind, 4> enum_values(LimitKind) {
  return {LimitKind::none, LimitKind::vibration, LimitKind::contraction, LimitKind::always};
}

/// Outcomes of one method over steps (or tolerances) and one other thing.
struct OutcomeMap {
  std::string label;    ///< "generalized-alpha, ρ∞ = 0.5"
  MethodSpec method;    ///< without step and tolerances
  bool by_step = true;  ///< settings are steps, s; otherwise rtol = atol
  MapAxis axis = MapAxis::parameter;
  std::vector<double> settings;        ///< rising
  std::vector<double> values;          ///< rising: of the parameter, elements, or s
  std::vector<StabilityPoint> points;  ///< values × settings, a value's settings side by side
  LimitKind limit_kind = LimitKind::none;
  std::vector<PredictedLimit> limits;  ///< one a value; empty for LimitKind::none and always
  std::string in_words;                ///< the step that a user would want
};

/// The step between stable and not, found by bisection to 1 %, beside the predicted one.
struct CriticalStep {
  std::string label;
  MethodSpec method;
  double parameter = 0;
  int elements = 0;
  double stable = -1;                 ///< the largest step found stable, s; -1: none
  double unstable = -1;               ///< the smallest step above it found not to be, s; -1: none
  Outcome beyond = Outcome::not_run;  ///< how the run with that step ended
  LimitKind limit_kind = LimitKind::none;
  PredictedLimit predicted;
};

/// Energy over time of one run.
struct EnergyHistory {
  std::string label;
  double parameter = 0;
  double step = 0;  ///< s
  Outcome outcome = Outcome::not_run;
  std::string message;
  std::vector<double> times;   ///< s
  std::vector<double> change;  ///< total energy minus the first, over the first kinetic energy
};

/// What a method does to one vibration in one period, measured beside the theory.
struct ModeAmplification {
  std::string label;
  double steps_a_period = 0;
  double measured = -1;   ///< amplitude after a period over that before
  double predicted = -1;  ///< amplification(ωh) to the power of steps a period
};

/// What does not depend on which of the neighbours of a motion a run follows, over all of its outputs.
struct MotionStatistics {
  std::string label;  ///< method, "reference", or the neighbour
  double parameter = 0;
  double step = 0;  ///< s; 0: not a fixed one
  Outcome outcome = Outcome::not_run;
  std::string message = {};
  double duration = 0;          ///< s
  bool taken = false;           ///< false of a run that failed: none of the figures below
  double mean_height = 0;       ///< of the last end, m
  double height_deviation = 0;  ///< standard deviation of that height, m
  double rms_speed = 0;         ///< of the last end, m/s
  double energy_change = 0;     ///< total energy, last minus first, over the first kinetic energy
};

/// Where methods fail on one case.
struct Stability {
  std::string title;
  std::string parameter;       ///< its name; empty: none varied
  double parameter_value = 0;  ///< of the case itself
  int elements = 0;            ///< of the case itself
  double end = 0;              ///< of the case and of maps over the parameter and the elements, s
  double duration = 0;         ///< longest, s
  double tolerance = 0;        ///< m
  std::vector<OutcomeMap> maps;
  std::vector<CriticalStep> critical_steps;
  std::vector<EnergyHistory> energies;
  std::vector<ModeAmplification> amplifications;
  std::vector<TrajectoryDivergence> divergences;
  std::vector<StabilityReference> references;
  std::vector<MotionStatistics> statistics;  ///< of motions beyond their horizon
  Provenance provenance;
};

}  // namespace plumb
