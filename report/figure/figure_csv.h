#pragma once

#include <string>

#include "render/plot/plot.h"

namespace plumb {

/// Everything in a plot that was drawn from numbers, one row each: `panel,kind,series,x,y,x_to,y_to,value`,
/// panels from 1, numbers with the digits that tell them from all others. Cells without meaning are empty. By
/// kind:
/// - `point` of a series: x, y. A series without a label has its number in the panel.
/// - `band`, `x_error`, `y_error` of a point: from (x, y) to (x_to, y_to).
/// - `rule`: from x to x_to or from y to y_to; series is its label.
/// - `bar`: corners, and as value its colour.
/// - `cell`: its middle (of a logarithmic axis, by ratio), and as value its category: letter or label or
///   number; or its number in a heat map.
/// - `tick` that is named: x or y, and as value its name.
std::string to_csv(const Plot& plot);

}  // namespace plumb
