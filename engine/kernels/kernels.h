#pragma once

#include <string_view>

#include "engine/kernels/sum.h"

namespace plumb {

/// |r'| below which a slope counts as collapsed (1: unstretched). The curvature is singular at r' = 0, and a
/// cable squeezed to a thousandth of its length is no cable; forces there are not evaluated, so nothing is
/// divided by it.
inline constexpr double slope_floor = 1e-3;

/// What the elements of a chain have in common.
struct ElementConstants {
  double axial_stiffness = 0;      ///< EA, N, ≥ 0
  double bending_stiffness = 0;    ///< EI, N m², ≥ 0
  double length = 0;               ///< l, m, > 0
  double mass_per_length = 0;      ///< ρA, kg/m, ≥ 0
  double per_mass[3] = {0, 0, 0};  ///< force on each unit of mass, N/kg
  bool green = true;               ///< green-geometric, else engineering-material
  bool full = true;                ///< full quadrature, else reduced
  bool lumped = false;             ///< half of the mass at either end, else consistent; not read by `force`
  bool straight = false;           ///< a link that only stretches; not read by kernels
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
  const MassFactor* middle;
};

/// What the supports make of the equations of the end nodes: what they hold gets the equation x = 0. Block
/// columns are those of Kernels::system, of whose diagonal blocks the rows above the diagonal are not set,
/// before or after.
class HeldEnds {
 public:
  /// Of the first node's block column.
  virtual void hold_first(double* column) const = 0;
  /// Of the last node's block column and that of the node before it.
  virtual void hold_last(double* column_before, double* column) const = 0;
  /// Of an end node's six numbers of the right-hand side.
  virtual void hold(bool last, double* numbers) const = 0;

 protected:
  ~HeldEnds() = default;
};

/// A constant force on one node.
struct NodeForce {
  int node;
  double force[6];  ///< on r (N) and on r' (N m)
};

/// At most one a node, in the order of nodes.
struct NodeForces {
  const NodeForce* first = nullptr;
  int count = 0;

  PLUMB_ALWAYS_INLINE const NodeForce* begin() const { return first; }
  PLUMB_ALWAYS_INLINE const NodeForce* end() const { return first + count; }

  /// Adds them to forces, six numbers a node.
  PLUMB_ALWAYS_INLINE void add_to(double* forces) const {
    for (const NodeForce& on : *this)
      for (int k = 0; k < 6; ++k) forces[6 * on.node + k] += on.force[k];
  }
};

/// factor · numbers, one array of a chain.
struct Scaled {
  double factor = 0;
  const double* numbers = nullptr;
};

/// An implicit stage for accelerations x, of which `from` is an estimate:
///   mass M (x + before) = force (f(base + reach x) + forces on nodes) + known.
struct StageTerms {
  Sum base;                    ///< m and 1; at most Sum::most − 1 terms
  double reach = 0;            ///< s²
  double mass = 1, force = 1;  ///< pure numbers
  Scaled before = {};          ///< m/s² and 1/s²; its numbers may be nullptr
  Scaled known = {};           ///< N and N m; its numbers may be nullptr
  Scaled from = {};            ///< m/s² and 1/s²; its numbers must be there

  /// base + reach x at the estimate.
  PLUMB_ALWAYS_INLINE Sum point() const {
    Sum sum = base;
    return sum.plus(reach * from.factor, from.numbers);
  }
  /// x + before at the estimate.
  PLUMB_ALWAYS_INLINE Sum accelerations() const {
    Sum sum(from.numbers);
    if (from.factor != 1) sum.plus(from.factor - 1, from.numbers);
    if (before.numbers != nullptr) sum.plus(before.factor, before.numbers);
    return sum;
  }
};

/// How a correction of a stage's x went.
struct StageCorrection {
  int unsound = -1;   ///< what `force` returns; unless -1, x and renewed factors must not be used
  int singular = -1;  ///< what `factor` returns; unless -1, x and the factors must not be used
  double position = 0, slope = 0;  ///< largest change of a position's and of a slope's x, m/s² and 1/s²
  bool finite = false;             ///< all changes are
};

/// A node's block column of a symmetric block tridiagonal matrix: six columns of twelve numbers, the upper
/// six the diagonal block, the lower six the block below it.
inline constexpr int block_rows = 12, block_column_size = 6 * block_rows;

/// Numbers a node of the factors of such a matrix.
inline constexpr int factor_size = 64;

/// Numbers of how `nodes` have turned since such a matrix was made.
constexpr int turns_size(int nodes) {
  constexpr int group = 4, numbers = 28;
  return numbers * ((nodes + group - 2) / group + 1);
}

/// The loops that a run spends its time in, written for vector units and built twice: for any x86-64 and,
/// where the processor has AVX2, for x86-64-v3. Both do the same operations in the same order without fused
/// multiply-add, so their results are the same to the last bit. `elements` is ≥ 1 and `nodes` ≥ 2. Arrays of
/// numbers hold 6 a node, r (m) and r' (1), or their rates or forces; block columns and factors have their
/// own sizes.
struct Kernels {
  std::string_view instruction_set;  ///< "plain", "x86-64-v3"

  /// f := ∫ ρA s per_mass dx − ∂U/∂q of all elements. Returns the first element with a slope at or below
  /// slope_floor, or not a number, at an integration point, where the force is not to be used; -1 if all is
  /// well.
  int (*force)(const ElementConstants& element, int elements, const double* q, double* f);

  /// a := M⁻¹ (f(q) + loads) with the factors of M, and the sums. All is done to a node
  /// while it is at hand, so that on long chains each array is read once, and most of that while forces are
  /// computed. Returns what `force` does.
  int (*acceleration)(const ElementConstants& element, int elements, const MassFactors& mass,
                      const NodeForces& loads, const StageSums& sums, double* a);

  /// Strain energies of stretching and bending of all elements, J.
  void (*energy)(const ElementConstants& element, int elements, const double* q, double* axial,
                 double* bending);

  /// The block columns of mass_factor · M + stiffness_factor · ∂²U/∂q², one a node; a pure number and one in
  /// s². The rows above the diagonal of the diagonal blocks are not set.
  void (*system)(const ElementConstants& element, double mass_factor, double stiffness_factor, int elements,
                 const double* q, double* block_columns);

  /// Makes the factors of a symmetric positive definite block tridiagonal matrix. Returns the node at which
  /// it turns out not to be one; -1 if all is well.
  int (*factor)(int nodes, const double* block_columns, double* factors);

  /// x := A⁻¹ x with the factors of A.
  void (*solve)(int nodes, const double* factors, double* x);

  /// `system` with supports and `factor` in one, without the block columns.
  int (*system_factors)(const ElementConstants& element, double mass_factor, double stiffness_factor,
                        int elements, const HeldEnds& ends, const double* q, double* factors);

  /// One correction of Newton's iteration for a stage: x := from + the residual of the stage at `from`,
  /// solved with the factors of a matrix. With `stiffness_factor` other than 0 these are first made of mass M
  /// + stiffness_factor K(point), K = ∂²U/∂q². With `turns` (else nullptr), turns_size() numbers that a
  /// new matrix sets, an old one is turned with the nodes. All numbers of a node are read once for the way to
  /// the last node and once for the way back. x must not be among those that the stage is made of.
  StageCorrection (*correct)(const ElementConstants& element, int elements, const HeldEnds& ends,
                             const NodeForces& loads, const StageTerms& stage, double stiffness_factor,
                             double* factors, double* turns, double* x);

  /// The same turns one by one: those of a matrix at q begin; x := Rᵀ x with R the turns up to q; and x := R
  /// x with the same.
  void (*mark_slopes)(int nodes, const double* q, double* turns);
  void (*turn_back)(int nodes, const double* q, double* turns, double* x);
  void (*turn)(int nodes, const double* turns, double* x);

  /// x := M⁻¹ x with the factors of M.
  void (*mass_solve)(int nodes, const MassFactors& factors, double* x);

  /// y := M v, without supports.
  void (*mass_multiply)(const ElementConstants& element, int elements, const double* v, double* y);

  /// Adds sums up over all nodes, one after the other as far as a node is concerned. A result may be one of
  /// its own terms, and one of those of the sums behind it.
  void (*add_up)(int nodes, Sums sums);

  /// ½ vᵀ M v, J.
  double (*kinetic_energy)(const ElementConstants& element, int elements, const double* v);
};

/// Those for this processor.
const Kernels& best_kernels();

/// Those for any x86-64, and those for x86-64-v3 or nullptr where the processor lacks it: for comparison.
const Kernels& plain_kernels();
const Kernels* v3_kernels();

}  // namespace plumb
