#include "engine/base/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {

std::string number_text(double value) {
  // The sign of a NaN depends on the machine and says nothing.
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

}  // namespace plumb
