#pragma once

#include <string_view>

namespace plumb {

/// |r'| below which a slope counts as collapsed (1: unstretched). The curvature is singular at r' = 0, and a
/// cable squeezed to a thousandth of its length is no cable; forces there are not evaluated, so nothing is
/// divided by it.
inline constexpr double slope_floor = 1e-3;

/// What the elements of a chain have in common.
struct ElementConstants {
  double axial_stiffness = 0;     ///< EA, N, ≥ 0
  double bending_stiffness = 0;   ///< EI, N m², ≥ 0
  double length = 0;              ///< l, m, > 0
  double mass_per_length = 0;     ///< ρA, kg/m, ≥ 0
  double gravity[3] = {0, 0, 0};  ///< m/s²
  bool green = true;              ///< green-geometric, else engineering-material
  bool full = true;               ///< full quadrature, else reduced
  bool lumped = false;            ///< half of the mass at either end, else consistent; not read by `force`
};

/// A node's part in the L D Lᵀ of the scalar mass matrix: the 2 by 2 multipliers of (r, g) of the node in the
/// rows of its neighbour towards the middle, and the inverse of the node's block of D. Coordinates that a
/// support holds have zeros.
struct MassFactor {
  double rr = 0, rg = 0, gr = 0, gg = 0;  ///< first letter: row of the neighbour; second: of the node
  double inverse_rr = 0, inverse_rg = 0, inverse_gg = 0;
};

/// The L D Lᵀ of the mass matrix, eliminated from both ends towards the node in the middle. All elements are
/// equal, so that from either end the factors settle after some thirty nodes: the last one of a list is that
/// of all nodes from there to the middle.
struct MassFactors {
  const MassFactor* from_left;      ///< of the first nodes
  const MassFactor* from_right;     ///< of the last nodes, the very last first
  int settled_left, settled_right;  ///< lengths of the lists, > 0
  MassFactor middle;
};

/// A node's block column of a symmetric block tridiagonal matrix: six columns of twelve numbers, the upper
/// six the diagonal block, the lower six the block below it.
inline constexpr int block_column_size = 72;

/// The loops that a run spends its time in, written for vector units and built twice: for any x86-64 and,
/// where the processor has AVX2, for x86-64-v3. Both do the same operations in the same order without fused
/// multiply-add, so their results are the same to the last bit. `elements` is ≥ 1 and `nodes` ≥ 2. All arrays
/// hold 6 numbers a node, r (m) and r' (1), or their rates or forces.
struct Kernels {
  std::string_view instruction_set;  ///< "plain", "x86-64-v3"

  /// f := weight − ∂U/∂q of all elements. Returns the first element with a slope at or below slope_floor, or
  /// not a number, at an integration point, where the force is not to be used; -1 if all is well.
  int (*force)(const ElementConstants& element, int elements, const double* q, double* f);

  /// Strain energies of stretching and bending of all elements, J.
  void (*energy)(const ElementConstants& element, int elements, const double* q, double* axial,
                 double* bending);

  /// The block columns of mass_factor · M + stiffness_factor · ∂²U/∂q², one a node; a pure number and one in
  /// s². The rows above the diagonal of the diagonal blocks are not set.
  void (*system)(const ElementConstants& element, double mass_factor, double stiffness_factor, int elements,
                 const double* q, double* block_columns);

  /// Factors a symmetric positive definite block tridiagonal matrix in place. Returns the node at which it
  /// turns out not to be one; -1 if all is well.
  int (*factor)(int nodes, double* block_columns);

  /// x := A⁻¹ x with the factors of A.
  void (*solve)(int nodes, const double* block_columns, double* x);

  /// x := M⁻¹ x with the factors of M.
  void (*mass_solve)(int nodes, const MassFactors& factors, double* x);

  /// y := M v, without supports.
  void (*mass_multiply)(const ElementConstants& element, int elements, const double* v, double* y);

  /// result := first + Σ factors[i] · terms[i] over `count` arrays of `size` numbers.
  void (*add_up)(int size, const double* first, int count, const double* factors, const double* const* terms,
                 double* result);

  /// ½ vᵀ M v, J.
  double (*kinetic_energy)(const ElementConstants& element, int elements, const double* v);
};

/// Those for this processor.
const Kernels& best_kernels();

/// Those for any x86-64, and those for x86-64-v3 or nullptr where the processor lacks it: for comparison.
const Kernels& plain_kernels();
const Kernels* v3_kernels();

}  // namespace plumb
