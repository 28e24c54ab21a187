#pragma once

#include <string>
#include <vector>

namespace plumb {

/// Which of three solutions the uncertainty is of.
enum class OfThree { finest, coarsest };

/// What three meshes say of one of them, over time.
struct MeshIndex {
  double order = -1;           ///< p that was observed; -1: the changes do not fall from mesh to mesh
  std::vector<double> values;  ///< grid convergence index, one a time; none unless the order is possible
};

/// The order that cubic elements have, and the greatest that the index is made with: one that is observed to
/// be higher is so by chance.
inline constexpr double mesh_order = 4;
/// The orders that are taken for those of the elements. Another one comes of curves that cross or of meshes
/// that are too coarse, and an extrapolation by it says nothing (Oberkampf and Roy 2010, Verification and
/// Validation in Scientific Computing, chapter 8).
inline constexpr double least_possible_order = 1, greatest_possible_order = mesh_order + 0.5;
bool is_possible_order(double order);

/// Roache's safety factors: of an order that is known, and of one that is not.
inline constexpr double certain_factor = 1.25, uncertain_factor = 3;

/// The grid convergence index (ASME V&V 20-2009, section 2-4; Roache 1994, J. Fluids Eng. 116, 405) over time
/// of one column on three meshes, each with half the elements of the one before:
///   F ε₂₁/(2^p − 1) for the finest, F ε₃₂ 2^p/(2^p − 1) for the coarsest, F = certain_factor,
/// with the order p, at most mesh_order, from the greatest changes ε₂₁, ε₃₂ over all times, by
/// grid_convergence(), and each change taken as the greatest up to that time: where curves cross, nothing is
/// certain. The three have as many values; of none there is no order.
MeshIndex mesh_index(const std::vector<double>& fine, const std::vector<double>& medium,
                     const std::vector<double>& coarse, OfThree of);

/// The same from two runs, where the order p of the method is taken for granted: F ε r^p/(r^p − 1) with F =
/// uncertain_factor, of a run whose step is `ratio` times that of the finer one.
std::vector<double> two_run_index(const std::vector<double>& run, const std::vector<double>& finer,
                                  double ratio, double order);

/// A bound where there is no order: uncertain_factor times the greatest change to another run up to each
/// time.
std::vector<double> two_run_bound(const std::vector<double>& run, const std::vector<double>& other);

}  // namespace plumb
