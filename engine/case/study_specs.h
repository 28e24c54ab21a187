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
  double loosest_tolerance = 0;          ///< rtol and atol, in (0, 1), of methods that take no step
  double tightest_tolerance = 0;         ///< less than the loosest
  int steps = 0;                         ///< of a map, 3 to 60, of equal ratio
  double tolerance = 0;   ///< greatest distance of a node to the reference in an accurate run, m, > 0
  double time_limit = 0;  ///< of one run, s, > 0
  std::vector<std::string> limit_methods;  ///< whose critical step is found by bisection
  double energy_step = 0;                  ///< s, of the runs whose energy is drawn over time

  friend bool operator==(const StabilitySpec&, const StabilitySpec&) = default;
};

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
  int cases = 0;          ///< 1 to 1,000,000
  long seed = 0;          ///< ≥ 0; case k depends on the seed and k alone
  double tolerance = 0;   ///< greatest distance of a node to the reference in an accurate run, m, > 0
  double time_limit = 0;  ///< of one run, s, > 0

  friend bool operator==(const SweepSpec&, const SweepSpec&) = default;
};

/// [study.economy]: what scenes of several sizes need, and random ones, each proven by a reference.
struct EconomySpec {
  std::vector<int> widths;             ///< of the picture, pixels, rising; its shape is that of the scene
  std::optional<CameraSpec> close_up;  ///< a second camera, beside that of the scene
  int scenes = 0;                      ///< random ones, 0 to 100,000
  long seed = 0;                       ///< ≥ 0; scene k depends on the seed and k alone
  int reference_elements = 0;  ///< at least; the reference is twice as fine as what is held against it

  friend bool operator==(const EconomySpec&, const EconomySpec&) = default;
};

}  // namespace plumb
