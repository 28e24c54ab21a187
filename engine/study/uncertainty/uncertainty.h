#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/case/report_specs.h"

namespace plumb {

/// What became of a part of the validation uncertainty.
enum class PartState {
  not_estimated,
  estimated,
  bounded,  ///< no estimate, but a bound in its place
  no_part,  ///< cannot contribute, which `how` says the reason of
};

/// "not estimated", "estimated", "bounded", "no part".
std::string_view word(PartState);
inline std::array<PartState, 4> enum_values(PartState) {
  return {PartState::not_estimated, PartState::estimated, PartState::bounded, PartState::no_part};
}

/// A source of the uncertainty of a comparison, over the times of the comparison.
struct UncertaintyPart {
  std::string name;  ///< "mesh", "time integration", "interpolation", "input", "data"
  PartState state = PartState::not_estimated;
  std::string how;  ///< how it was estimated, or why not, in words
  /// Standard uncertainty, in the unit of the series; none unless estimated or bounded.
  std::vector<double> values;

  bool has_values() const { return state == PartState::estimated || state == PartState::bounded; }
};

/// The comparison error E = S − D of one series with its validation uncertainty, after ASME V&V 20-2009.
struct SeriesUncertainty {
  std::string reference;  ///< name of the [[reference]]
  std::string series;     ///< "mid_y"
  std::string column;     ///< "mid.y"
  std::string unit;
  bool published = false;     ///< the reference validates; a computed one verifies
  std::vector<double> times;  ///< s, those of the reference that the run can be held against; one or more
  std::vector<double> error;  ///< E, run minus reference
  std::vector<UncertaintyPart> parts;  ///< mesh, time integration, interpolation, input, data
  std::vector<double> validation;      ///< u_val, root of the sum of squares of the estimated parts

  std::size_t greatest = 0;         ///< of `times`, where |E| is greatest
  double share_within = -1;         ///< of `times` with |E| ≤ k u_val, 0 to 1
  std::vector<std::size_t> beyond;  ///< of `times`, those with |E| > k u_val
  std::string finding;              ///< what follows for the model, in words, over all times
  std::string
      shared_model;  ///< what the models behind both leave out, which no comparison shows; may be empty
  std::string explanation;  ///< which part of the error budget accounts for it; may be empty

  /// False where a part is not estimated: then u_val is at least what it says.
  bool whole() const;
};

/// An input with the value that the case gives it, in SI units.
struct SampledInput {
  UncertainInput input;
  double value = 0;
};

/// What a sampling of the uncertain inputs was and how it went.
struct InputSampling {
  int samples = 0;
  long seed = 0;
  int completed = 0;
  std::vector<std::string> failures;  ///< one a sample that has no result: what was sampled and what happened
  std::vector<SampledInput> inputs;
};

/// The validation uncertainty of every series of a run that could be held against its reference.
struct Uncertainty {
  std::vector<SeriesUncertainty> series;
  std::vector<std::string> left_out;  ///< "published: mid.y: why", where nothing could be estimated
  InputSampling sampling;
  int runs = 0;         ///< that were made for it
  double seconds = -1;  ///< they took, by the clock
};

/// k: an expanded uncertainty is k standard ones, and covers some 95 % where errors are normal.
inline constexpr double coverage_factor = 2;

inline constexpr const char* validation_standard = "ASME V&V 20-2009";

}  // namespace plumb
