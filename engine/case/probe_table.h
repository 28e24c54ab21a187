#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// One scalar over the output times.
struct Column {
  std::string name;  ///< "tip.x"
  std::string unit;  ///< "m"
  std::vector<double> values;
};

/// What the probes of a case saw: one column for each scalar, one value for each output time.
struct ProbeTable {
  std::vector<double> times;  ///< s
  std::vector<Column> columns;

  /// The column of that name, or nullptr.
  const Column* find(std::string_view name) const;
};

}  // namespace plumb
