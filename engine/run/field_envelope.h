#pragma once

#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

class Cable;

/// The least, mean and greatest value over time of a field, along the cable, in the field's unit: what cable
/// engineers call range graphs.
struct FieldEnvelope {
  /// Distances from the first end along the unstretched cable, m, ascending; the boundary of two elements is
  /// there twice, as curvature jumps there: the end of one, and the start of the next.
  std::vector<double> places;
  std::vector<double> least;     ///< one a place; not a number where no output has a finite value
  std::vector<double> mean;      ///< over time: the trapezoidal rule over the outputs
  std::vector<double> greatest;  ///< one a place
  double peak = 0;               ///< the greatest of all
  double peak_place = 0;         ///< m
  double peak_time = 0;          ///< s
};

/// Over the outputs of a trajectory of this cable whose states are finite. Each element has places enough for
/// a smooth curve: up to 33 or, on fine meshes, fewer, but at least its two ends.
FieldEnvelope field_envelope(const Cable& cable, ColorField field, const Trajectory& trajectory);

}  // namespace plumb
