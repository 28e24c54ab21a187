#pragma once

#include <string>
#include <vector>

namespace plumb {

/// Which of three solutions the uncertainty is of.
enum class OfThree { finest, coarsest };

/// What three meshes say of one of them, over time.
struct MeshIndex {
  double order = -1;           ///< p that was observed; -1: the changes do not fall from mesh to mesh
  double safety_factor = -1;   ///< Roache's: 1.25 where the order is near to what theory has, else 3
  std::vector<double> values;  ///< grid convergence index, one a time; none where the order is -1
};

/// The order that cubic elements have, and the greatest that the index is made with: one that is observed to
/// be higher is so by chance.
inline constexpr double mesh_order = 4;
/// The least order that the index is made with: below it the formula blows up and says nothing (Oberkampf and
/// Roy 2010, Verification and Validation in Scientific Computing, chapter 8).
inline constexpr double least_mesh_order = 0.5;

/// The order that the index is made with where `order` is observed.
double counted_order(double order);

/// The grid convergence index (ASME V&V 20-2009, section 2-4; Roache 1994, J. Fluids Eng. 116, 405) over time
/// of one column on three meshes, each with half the elements of the one before:
///   F ε₂₁/(2^p − 1) for the finest, F ε₃₂ 2^p/(2^p − 1) for the coarsest,
/// with the order p from the greatest changes ε₂₁, ε₃₂ over all times, by grid_convergence(), and each change
/// taken as the greatest up to that time: where curves cross, nothing is certain. The three have as many
/// values; of none there is no order.
MeshIndex mesh_index(const std::vector<double>& fine, const std::vector<double>& medium,
                     const std::vector<double>& coarse, OfThree of);

/// The same from two runs, where the order p of the method is taken for granted: F ε r^p/(r^p − 1) with F =
/// 3, of a run whose step is `ratio` times that of the finer one.
std::vector<double> two_run_index(const std::vector<double>& run, const std::vector<double>& finer,
                                  double ratio, double order);

}  // namespace plumb
