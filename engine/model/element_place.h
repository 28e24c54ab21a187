#pragma once

#include <array>

#include "engine/case/case.h"
#include "engine/model/own_units.h"

namespace plumb {

/// A place within an element: r and r' there are sums over the nodal vectors (r₀, r'₀, r₁, r'₁) of its two
/// nodes. A chain is straight between its nodes.
struct ElementPlace {
  std::array<double, 4> position;  ///< 1 and m
  std::array<double, 4> slope;     ///< 1/m and 1
  double length;                   ///< of the cable that it stands for, m; 0 of a point

  ElementPlace in_units(const OwnUnits& units) const;
};

/// The element of a fraction of the length, and the place in it.
struct PlaceOnCable {
  int element;
  ElementPlace place;
};

/// At x in [0, 1] of an element.
ElementPlace element_place(const CableSpec& cable, double x, double length = 0);
/// At the fraction s in [0, 1] of the cable's length.
PlaceOnCable place_on_cable(const CableSpec& cable, double s);

}  // namespace plumb
