#pragma once

namespace plumb {

/// Energies at one time, J. Potential energy is that of the loads, 0 at the origin.
struct Energies {
  double kinetic = 0;
  double axial = 0;      ///< strain energy of stretching
  double bending = 0;    ///< strain energy of bending
  double potential = 0;  ///< of the loads
  /// Of a state between two steps: what these four are more than their sum at the end of the step it lies in,
  /// which is no energy that a method gained or lost.
  double interpolation = 0;

  double total() const { return kinetic + axial + bending + potential - interpolation; }
};

}  // namespace plumb
