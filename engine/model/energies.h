#pragma once

namespace plumb {

/// Energies at one time, J. Potential energy is that of the loads, 0 at the origin.
struct Energies {
  double kinetic = 0;
  double axial = 0;      ///< strain energy of stretching
  double bending = 0;    ///< strain energy of bending
  double potential = 0;  ///< of the loads

  double total() const { return kinetic + axial + bending + potential; }
};

}  // namespace plumb
