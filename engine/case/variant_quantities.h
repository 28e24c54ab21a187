#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// A number of a finished run that a variant can be expected to show.
struct VariantQuantity {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
};

/// Those that need no column of the probes.
std::span<const VariantQuantity> variant_quantities();

/// A quantity that is read off a column: "tip.x", "greatest tip.x", "least tip.x".
struct ColumnQuantity {
  enum class Of { last, greatest, least };
  Of of = Of::last;
  std::string column;
};

/// Takes such a quantity apart.
ColumnQuantity column_quantity(const std::string& quantity);

}  // namespace plumb
