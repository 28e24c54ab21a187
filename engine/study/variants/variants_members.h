#pragma once

#include <optional>
#include <utility>

#include "engine/base/codec.h"
#include "engine/run/probes_json.h"
#include "engine/run/stored_parts.h"
#include "engine/study/variants/variants.h"

/// What the journal and study.json keep of variants.
namespace plumb {

template <class Archive>
void members(Archive& a, ExpectationFound& figure) {
  a("quantity", figure.expected.quantity);
  a("unit", figure.unit);
  a("found", figure.found);
}

/// Without what the case says, and without states.
template <class Archive>
void members(Archive& a, VariantResult& variant) {
  Trajectory& t = variant.trajectory;
  a("name", variant.spec.name);
  a("outcome", t.outcome);
  a("message", t.message);
  a("elements", t.elements);
  a("element_length", t.element_length);
  a("end_time", t.end_time);
  a("solve_seconds", t.solve_seconds);
  a("constraint_drift", t.constraint_drift);
  a("interpolated_outputs", t.interpolated_outputs);
  std::optional<Equilibria> equilibria;
  if (!t.equilibria.path.empty()) equilibria = t.equilibria;
  a("equilibria", equilibria);
  if (equilibria) t.equilibria = std::move(*equilibria);
  a("counters", t.counters);
  a("time", t.times);
  a("energy", t.energies);
  a("probes", variant.probes.columns);
  a("figures", variant.expectations);
}

}  // namespace plumb
