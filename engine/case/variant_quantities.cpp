#include "engine/case/variant_quantities.h"

namespace plumb {

std::span<const VariantQuantity> variant_quantities() {
  static constexpr VariantQuantity all[] = {
      {"end-time", "s", "time reached"},
      {"energy-ratio", "1", "last total energy over the first"},
      {"energy-change", "1", "last total energy minus the first, over the first kinetic energy"},
      {"energy-drift", "1", "greatest change of the total energy, over the first kinetic energy"},
      {"constraint-drift", "m", "greatest way that a held end has gone"},
      {"growth", "1",
       "factor by which a vibration in the first column of the probes grows from output to output"},
      {"distance", "m", "greatest distance of a node from the same one of another variant"},
  };
  return all;
}

}  // namespace plumb
