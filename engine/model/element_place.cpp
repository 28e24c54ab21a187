#include "engine/model/element_place.h"

#include <algorithm>

#include "engine/model/hermite.h"

namespace plumb {

ElementPlace ElementPlace::in_units(const OwnUnits& units) const {
  ElementPlace result = *this;
  for (const std::size_t of_slope : {1U, 3U}) result.position[of_slope] /= units.length;
  for (const std::size_t of_position : {0U, 2U}) result.slope[of_position] *= units.length;
  result.length /= units.length;
  return result;
}

ElementPlace element_place(const CableSpec& cable, double x, double length) {
  const double l = cable.length / cable.elements;
  if (cable.model == CableModel::chain) return {{1 - x, 0, x, 0}, {-1 / l, 0, 1 / l, 0}, length};
  return {Hermite::values(x, l), Hermite::slopes(x, l), length};
}

PlaceOnCable place_on_cable(const CableSpec& cable, double s) {
  const double along = s * cable.elements;
  const int element = std::clamp(static_cast<int>(along), 0, cable.elements - 1);
  return {element, element_place(cable, along - element)};
}

}  // namespace plumb
