#pragma once

#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

class Cable;

/// A field over time and place in cells that are small enough for a picture.
struct FieldMap {
  std::vector<double> time_edges;   ///< s, rising, one more than columns; halfway between outputs
  std::vector<double> place_edges;  ///< m from the first end, rising, one more than rows
  /// Rows by place, each by time, in the field's unit: the mean of up to 4 by 4 outputs and places in the
  /// cell; not a number where none of them is finite.
  std::vector<double> values;
};

/// Every output and several places an element where these are no more than the given numbers of columns and
/// rows, both ≥ 1; else they are put together. Without cells where there are fewer than two outputs. The work
/// is bounded by the cells, not by elements and outputs.
FieldMap field_map(const Cable& cable, ColorField field, const Trajectory& trajectory, int most_columns,
                   int most_rows);

}  // namespace plumb
