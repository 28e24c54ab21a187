#pragma once

#include <Eigen/Core>

namespace plumb {

/// Vectors (a column each) from which iterations for the first few modes of that many nodes start: of no
/// symmetry, so that no mode is missed, and smooth along the cable, as modes are. No more than there are
/// nodes.
Eigen::MatrixXd starting_modes(int nodes, Eigen::Index wished);

/// How much of each of some modes (a column each) makes the combination that moves most along one axis: y
/// before z before x where these are alike. Empty where none moves.
template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 1> towards_an_axis(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& modes);

/// Turns modes (a column each) of one frequency by a unitary matrix, so that the first moves most along one
/// axis, as towards_an_axis has it, the second does so of what is left, and so on. Each is real and > 0 where
/// it moves most along it.
template <class Scalar>
void turn_towards_axes(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& modes);

/// Greatest displacement of a node in a change of the coordinates, m.
double greatest_displacement(const Eigen::VectorXd& dq);

}  // namespace plumb
