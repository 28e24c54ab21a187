#pragma once

#include <Eigen/Core>

namespace plumb {

/// Vectors (a column each) from which iterations for the first few modes of that many nodes start: of no
/// symmetry, so that no mode is missed, and smooth along the cable, as modes are. No more than there are
/// nodes.
Eigen::MatrixXd starting_modes(int nodes, Eigen::Index wished);

/// How much of each of some modes (a column each) makes the combination that moves most along one axis: y
/// before z before x where these are alike. Empty where none moves.
Eigen::VectorXd towards_an_axis(const Eigen::MatrixXd& modes);

/// Greatest displacement of a node in a change of the coordinates, m.
double greatest_displacement(const Eigen::VectorXd& dq);

}  // namespace plumb
