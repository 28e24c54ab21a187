#pragma once

namespace plumb {

/// What has no potential has done since the start, J.
struct Work {
  double supplied = 0;    ///< by loads, and by the motion of supports
  double dissipated = 0;  ///< by damping

  Work& operator+=(const Work& other) {
    supplied += other.supplied;
    dissipated += other.dissipated;
    return *this;
  }
};

/// Energies at one time, J. Potential energy is that of the loads, 0 at the origin.
struct Energies {
  double kinetic = 0;
  double axial = 0;       ///< strain energy of stretching
  double bending = 0;     ///< strain energy of bending
  double potential = 0;   ///< of the loads that are constant forces
  double work = 0;        ///< done since the start by the other loads and by the motion of supports
  double dissipated = 0;  ///< since the start by damping
  /// Of a state between two steps: what all these come to more than their sum at the end of the step it lies
  /// in, which is no energy that a method gained or lost.
  double interpolation = 0;

  /// What stays the same but for errors.
  double total() const { return kinetic + axial + bending + potential - work + dissipated - interpolation; }
};

}  // namespace plumb
