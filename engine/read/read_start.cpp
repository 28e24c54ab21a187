#include <cmath>

#include "engine/read/case_sections.h"

namespace plumb {

StartSpec read_start(TableReader table) {
  StartSpec start;
  start.direction = table.vector("direction", "", start.direction);
  start.angular_velocity = table.vector("angular_velocity", "rad/s", start.angular_velocity);
  start.slope_rates = table.choice<SlopeRates>("slope_rates", start.slope_rates);
  start.axial_speed = table.number("axial_speed", Range::any("m/s"), start.axial_speed);
  table.finish();

  // Scaled by its largest component first: the square of a tiny or huge one is not a number to divide by.
  const double largest = start.direction.cwiseAbs().maxCoeff();
  if (largest == 0) table.refuse_value("direction", "must not be zero");
  start.direction = (start.direction / largest).normalized();
  return start;
}

}  // namespace plumb
