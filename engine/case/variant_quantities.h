#pragma once

#include <span>
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

}  // namespace plumb
