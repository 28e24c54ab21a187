#include <cmath>

#include "engine/base/units.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

bool feed(std::string_view input) {
  bool known = false;
  for (const char* base : {"s", "m", "m/s", "1", "N", "1/m", "N m"}) {
    const auto factor = unit_factor(input, base);
    if (!factor)
      promise(!unit_fault(input, base).empty(), "nothing is said of a unit that is unknown");
    else
      promise(std::isfinite(*factor) && *factor > 0, "a unit's factor out of range");
    known = known || factor.has_value();
  }
  return known;
}

std::vector<std::string> seeds() {
  std::vector<std::string> units;
  for (const char* base : {"s", "m", "m/s", "1", "N", "1/m", "N m"})
    for (std::string& unit : units_like(base)) units.push_back(std::move(unit));
  return units;
}

}  // namespace

const Target unit_target{"unit", feed, seeds};

}  // namespace plumb::fuzz
