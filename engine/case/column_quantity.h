#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/probe_columns.h"

namespace plumb {

/// A number that is read off a column up to some time: "tip.x", "greatest tip.x", "time of least tip.x",
/// "period tip.x".
struct ColumnQuantity {
  enum class Of { last, greatest, least, time_of_greatest, time_of_least, period };
  Of of = Of::last;
  std::string column;

  /// It is more than the column itself at one time.
  bool is_aggregate() const { return of != Of::last; }
};

/// Takes such a quantity apart.
ColumnQuantity column_quantity(const std::string& quantity);

/// The words that may stand before a column: "greatest, least, time of greatest, …".
std::string aggregate_words();

/// Unit of the column, or s; nothing where there is no such column.
std::optional<std::string_view> unit(const ColumnQuantity&, const ProbeColumns&);

/// A number that was read off a column, or why there is none.
struct ColumnNumber {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< not a number where there is a fault
  std::string fault;
};

/// Of the values that a column has at `times` (s, strictly increasing, one or more), up to `until` (s).
/// Between times they are interpolated (TimeInterpolation) unless nothing is known there. A period is the
/// mean time (s) between crossings, upward, of the middle between the least and the greatest value.
ColumnNumber column_number(ColumnQuantity::Of, const std::vector<double>& times,
                           const std::vector<double>& values, double until, bool known_between = true);

}  // namespace plumb
