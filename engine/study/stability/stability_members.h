#pragma once

#include "engine/base/codec.h"
#include "engine/run/method_json.h"
#include "engine/study/stability/stability.h"

/// What the journal and study.json keep of a stability study, by the names of its members.
namespace plumb {

template <class Archive>
void members(Archive& a, StabilityPoint& p) {
  a("outcome", p.outcome);
  a("message", p.message);
  a("end_time", p.end_time);
  a("error", p.error);
  a("judged_until", p.judged_until);
  a("energy_change", p.energy_change);
  a("steps", p.steps);
  a("seconds", p.seconds);
}

template <class Archive>
void members(Archive& a, PredictedLimit& p) {
  a("at_start", p.at_start);
  a("at_worst", p.at_worst);
}

template <class Archive>
void members(Archive& a, OutcomeMap& m) {
  a("label", m.label);
  a("method", m.method);
  a("by_step", m.by_step);
  a("axis", m.axis);
  a("settings", m.settings);
  a("values", m.values);
  a("limit_kind", m.limit_kind);
  a("limits", m.limits);
  a("in_words", m.in_words);
  a("points", m.points);
}

template <class Archive>
void members(Archive& a, CriticalStep& c) {
  a("label", c.label);
  a("method", c.method);
  a("parameter", c.parameter);
  a("elements", c.elements);
  a("stable", c.stable);
  a("unstable", c.unstable);
  a("beyond", c.beyond);
  a("limit_kind", c.limit_kind);
  a("predicted", c.predicted);
}

template <class Archive>
void members(Archive& a, EnergyHistory& e) {
  a("label", e.label);
  a("parameter", e.parameter);
  a("step", e.step);
  a("outcome", e.outcome);
  a("message", e.message);
  a("times", e.times);
  a("change", e.change);
}

template <class Archive>
void members(Archive& a, ModeAmplification& m) {
  a("label", m.label);
  a("steps_a_period", m.steps_a_period);
  a("measured", m.measured);
  a("predicted", m.predicted);
}

template <class Archive>
void members(Archive& a, TrajectoryDivergence& s) {
  a("parameter", s.parameter);
  a("elements", s.elements);
  a("times", s.times);
  a("distances", s.distances);
  a("exponent", s.exponent);
  a("horizon", s.horizon);
  a("beyond_end", s.beyond_end);
  a("in_words", s.in_words);
}

template <class Archive>
void members(Archive& a, MotionStatistics& s) {
  a("label", s.label);
  a("parameter", s.parameter);
  a("step", s.step);
  a("outcome", s.outcome);
  a("message", s.message);
  a("duration", s.duration);
  a("taken", s.taken);
  a("mean_height", s.mean_height);
  a("height_deviation", s.height_deviation);
  a("rms_speed", s.rms_speed);
  a("energy_change", s.energy_change);
}

template <class Archive>
void members(Archive& a, StabilityReference& r) {
  a("parameter", r.parameter);
  a("elements", r.elements);
  a("duration", r.duration);
  a("first", r.first);
  a("second", r.second);
  a("agreement", r.agreement);
  a("trusted_until", r.trusted_until);
  a("frequency_at_start", r.frequency_at_start);
  a("frequency_at_worst", r.frequency_at_worst);
}

/// Without case and trajectory, which follow from the others.
template <class Archive>
void members(Archive& a, ReferenceMotion& m) {
  a("parameter", m.parameter);
  a("method", m.method);
  a("summary", m.summary);
  a("separation", m.divergence);
}

template <class Archive>
void members(Archive& a, Stability& s) {
  a("title", s.title);
  a("parameter", s.parameter);
  a("parameter_value", s.parameter_value);
  a("elements", s.elements);
  a("end", s.end);
  a("duration", s.duration);
  a("tolerance", s.tolerance);
  a("maps", s.maps);
  a("critical_steps", s.critical_steps);
  a("energies", s.energies);
  a("amplifications", s.amplifications);
  a("separations", s.divergences);
  a("statistics", s.statistics);
  a("references", s.references);
  a("provenance", s.provenance);
}

}  // namespace plumb
