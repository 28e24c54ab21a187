#include "engine/model/straight_frequency.h"

#include <algorithm>
#include <cmath>

namespace plumb {

double straight_frequency(const CableSpec& cable) {
  const double l = cable.length / cable.elements;
  const double axial = 9.55 * std::sqrt(cable.youngs_modulus / cable.density) / l;
  const double bending =
      std::sqrt(8400 * cable.youngs_modulus * cable.second_moment / (cable.density * cable.area)) / (l * l);
  return std::max(axial, bending);
}

}  // namespace plumb
