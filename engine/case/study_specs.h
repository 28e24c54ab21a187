#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/case/scene_settings.h"

namespace plumb {

/// [study.stability]: every method over steps and what makes them fail.
struct StabilitySpec {
  std::string parameter;                 ///< of [parameters], varied beside the step; empty: none
  std::vector<double> parameter_values;  ///< rising
  std::vector<int> elements;             ///< meshes, rising
  std::vector<double> durations;         ///< s, rising; the other maps go to the end of the case
  std::vector<std::string> methods;      ///< names, in the order of method_infos()
  double largest_step = 0;               ///< s
  double smallest_step = 0;              ///< s, less than the largest
  double loosest_tolerance = 0;          ///< rtol and atol, of methods that take no step
  double tightest_tolerance = 0;         ///< less than the loosest
  int steps = 0;                         ///< of a map, of equal ratio
  double tolerance = 0;   ///< greatest distance of a node to the reference in an accurate run, m
  double time_limit = 0;  ///< of one run, s
  std::vector<std::string> limit_methods;  ///< whose critical step is found by bisection
  double energy_step = 0;                  ///< s, of the runs whose energy is drawn over time

  friend bool operator==(const StabilitySpec&, const StabilitySpec&) = default;
};

/// All but the parameter and the lists.
void visit_keys(SpecOf<StabilitySpec> auto& study, auto&& visit) {
  visit(Key{.name = "largest_step", .range = Range::positive("s")}, study.largest_step);
  visit(Key{.name = "smallest_step", .range = Range::positive("s")}, study.smallest_step);
  visit(Key{.name = "loosest_tolerance", .range = Range::below_one()}, study.loosest_tolerance);
  visit(Key{.name = "tightest_tolerance", .range = Range::below_one()}, study.tightest_tolerance);
  visit(Key{.name = "steps", .range = Range::whole_between(3, 60)}, study.steps);
  visit(Key{.name = "tolerance", .range = Range::positive("m")}, study.tolerance);
  visit(Key{.name = "time_limit", .range = Range::positive("s")}, study.time_limit);
  visit(Key{.name = "energy_step", .range = Range::positive("s")}, study.energy_step);
}

/// [[study.variant.expect]]: a figure that a variant is to show.
struct ExpectationSpec {
  /// One of variant_quantities() (engine/case/variant_quantities.h), a column of the probes at the last
  /// output, or "greatest COLUMN" or "least COLUMN" over the outputs.
  std::string quantity;
  std::string from;  ///< name of the variant that a "distance" is to; otherwise empty
  double value = 0;
  double within = 0;   ///< > 0, in the unit of the quantity
  std::string source;  ///< where the value is from, required

  friend bool operator==(const ExpectationSpec&, const ExpectationSpec&) = default;
};

/// [[study.variant]]: the case with some keys changed, and how that is expected to end.
struct VariantSpec {
  std::string name;                    ///< unique
  std::vector<std::string> overrides;  ///< "method.step=0.2", as --set takes them
  std::string outcome;                 ///< the expected one, a word of outcomes(); empty: any
  std::string says;                    ///< what the message of its end has to hold; empty: anything
  std::string reason;                  ///< why that is expected; may be empty
  std::vector<ExpectationSpec> expectations;

  /// False where it is only there to be seen beside others.
  bool expects_anything() const { return !outcome.empty() || !says.empty() || !expectations.empty(); }

  friend bool operator==(const VariantSpec&, const VariantSpec&) = default;
};

/// [study.sweep]: random cases near the one of the file.
struct SweepSpec {
  int cases = 0;
  long seed = 0;          ///< case k depends on the seed and k alone
  double tolerance = 0;   ///< greatest distance of a node to the reference in an accurate run, m
  double time_limit = 0;  ///< of one run, s

  friend bool operator==(const SweepSpec&, const SweepSpec&) = default;
};

void visit_keys(SpecOf<SweepSpec> auto& study, auto&& visit) {
  visit(Key{.name = "cases", .range = Range::whole_between(1, 1e6)}, study.cases);
  visit(Key{.name = "seed", .range = Range::seed()}, study.seed);
  visit(Key{.name = "tolerance", .range = Range::positive("m")}, study.tolerance);
  visit(Key{.name = "time_limit", .range = Range::positive("s")}, study.time_limit);
}

/// [study.economy]: what scenes of several sizes need, and random ones, each proven by a reference.
struct EconomySpec {
  std::vector<int> widths;             ///< of the picture, pixels, rising; its shape is that of the scene
  std::optional<CameraSpec> close_up;  ///< a second camera, beside that of the scene
  int scenes = 0;                      ///< random ones
  long seed = 0;                       ///< scene k depends on the seed and k alone
  int reference_elements = 0;  ///< at least; the reference is twice as fine as what is held against it

  friend bool operator==(const EconomySpec&, const EconomySpec&) = default;
};

/// All but the widths and the camera.
void visit_keys(SpecOf<EconomySpec> auto& study, auto&& visit) {
  visit(Key{.name = "scenes", .range = Range::whole_between(0, 1e5)}, study.scenes);
  visit(Key{.name = "seed", .range = Range::seed()}, study.seed);
  visit(Key{.name = "reference_elements", .range = Range::whole_between(2, 4096)}, study.reference_elements);
}

/// A mistake of a program, made on purpose to see which criteria notice it.
enum class Blunder {
  no_bending,        ///< EI = 0
  chain,             ///< a chain of springs and masses in the place of the cable
  strain_model,      ///< the other one
  half_mesh,         ///< half as many elements
  double_mesh,       ///< twice as many, which is more right than wrong
  lumped_mass,       ///< half of each element's mass at either end
  zero_slope_rates,  ///< at the start
  first_order,       ///< an implicit integrator of order 1
  rounded_gravity,   ///< 9.8 for 9.81 m/s², or the reverse
  density_unit,      ///< a density 1000 times too large or too small
  other_sign,        ///< of one load
  late_output,       ///< each output is that of one interval before
};

/// [sensitivity]: which mistakes the criteria of the case notice.
struct SensitivitySpec {
  std::vector<std::string> numbers;  ///< that are changed: keys of model_numbers()
  std::vector<Blunder> blunders;     ///< that are made where the case can make them
  double largest = 0;                ///< factor up to which, and share down to which, numbers are changed
  double time_limit = 0;             ///< of one run, s

  friend bool operator==(const SensitivitySpec&, const SensitivitySpec&) = default;
};

/// All but its lists.
void visit_keys(SpecOf<SensitivitySpec> auto& study, auto&& visit) {
  visit(Key{.name = "largest", .range = Range::between(1.01, 1e6, "")}, study.largest);
  visit(Key{.name = "time_limit", .range = Range::positive("s")}, study.time_limit);
}

}  // namespace plumb
