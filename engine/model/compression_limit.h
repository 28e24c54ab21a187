#pragma once

#include <Eigen/Core>
#include <optional>

namespace plumb {

class Cable;

/// Most compression that a bar with Green's strain can bear, over EA: the least of N/EA = ½(λ² − 1) λ, at the
/// stretch λ = 1/√3, is −1/(3 √3). Pressed harder, it has no equilibrium short of being turned inside out.
inline constexpr double green_compression_limit = 0.19245008972987526;

/// An element pressed with more than that, and with how much.
struct OverloadedElement {
  int element;
  double compression;  ///< over EA, > 0
};

/// The element that `fraction` of the load presses hardest along the chords of q, if that is more than
/// Green's strain bears. Nothing for engineering strain, and nothing where both ends are held, as the
/// supports then share the load in a way that equilibrium alone does not tell.
std::optional<OverloadedElement> overloaded_element(const Cable& cable, const Eigen::VectorXd& q,
                                                    double fraction);

}  // namespace plumb
