// Built once for each instruction set; PLUMB_KERNELS names the table that this build defines.
#include "engine/kernels/acceleration.h"
#include "engine/kernels/stage.h"

namespace plumb::kernels {
namespace {

/// The instance for the strain model and quadrature of a chain.
#define PLUMB_CHOOSE(function, element, ...)                                        \
  ((element).green ? ((element).full ? function<true, true>(element, __VA_ARGS__)   \
                                     : function<true, false>(element, __VA_ARGS__)) \
                   : ((element).full ? function<false, true>(element, __VA_ARGS__)  \
                                     : function<false, false>(element, __VA_ARGS__)))

int force(const ElementConstants& element, int elements, const double* q, double* f) {
  return PLUMB_CHOOSE(chain_force, element, elements, q, f);
}

void energy(const ElementConstants& element, int elements, const double* q, double* axial, double* bending) {
  PLUMB_CHOOSE(chain_energy, element, elements, q, axial, bending);
}

ElementConstants scaled_by(double mass_factor, double stiffness_factor, const ElementConstants& element) {
  ElementConstants scaled = element;
  scaled.axial_stiffness *= stiffness_factor;
  scaled.bending_stiffness *= stiffness_factor;
  scaled.mass_per_length *= mass_factor;
  return scaled;
}

void system(const ElementConstants& element, double mass_factor, double stiffness_factor, int elements,
            const double* q, double* block_columns) {
  const ElementConstants scaled = scaled_by(mass_factor, stiffness_factor, element);
  PLUMB_CHOOSE(chain_system, scaled, elements, q, block_columns);
}

int system_factors(const ElementConstants& element, double mass_factor, double stiffness_factor, int elements,
                   const HeldEnds& ends, const double* q, double* factors) {
  const ElementConstants scaled = scaled_by(mass_factor, stiffness_factor, element);
  return PLUMB_CHOOSE(chain_factors, scaled, elements, ends, q, factors);
}

StageCorrection correct(const ElementConstants& element, int elements, const HeldEnds& ends,
                        const NodeForces& loads, const StageTerms& stage, double stiffness_factor,
                        double* factors, double* turns, double* x) {
  const ElementConstants scaled = scaled_by(stage.mass, stiffness_factor, element);
  return PLUMB_CHOOSE(chain_correction, element, scaled, stiffness_factor != 0, elements, ends, loads, stage,
                      factors, turns, x);
}

int acceleration(const ElementConstants& element, int elements, const MassFactors& mass,
                 const NodeForces& loads, const StageSums& sums, double* a) {
  return PLUMB_CHOOSE(chain_acceleration, element, elements, mass, loads, sums, a);
}

void add_up(int nodes, Sums sums) {
  // By blocks, so that what several sums share is read once.
  constexpr int block = 64;
  for (int from = 0; from < nodes; from += block)
    for (const Sum& sum : sums) add_up(sum, from, nodes - from < block ? nodes : from + block);
}

}  // namespace

extern const Kernels PLUMB_KERNELS;
const Kernels PLUMB_KERNELS{PLUMB_INSTRUCTION_SET,
                            force,
                            acceleration,
                            energy,
                            system,
                            factor,
                            solve,
                            system_factors,
                            correct,
                            mark_slopes,
                            turn_back,
                            turn,
                            mass_solve,
                            mass_multiply,
                            add_up,
                            kinetic_energy};

}  // namespace plumb::kernels
