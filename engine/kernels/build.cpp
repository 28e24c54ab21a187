// Built once for each instruction set; PLUMB_KERNELS names the table that this build defines.
#include "engine/kernels/block_factors.h"
#include "engine/kernels/chain.h"
#include "engine/kernels/mass_band.h"

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

void system(const ElementConstants& element, double mass_factor, double stiffness_factor, int elements,
            const double* q, double* block_columns) {
  ElementConstants scaled = element;
  scaled.axial_stiffness *= stiffness_factor;
  scaled.bending_stiffness *= stiffness_factor;
  scaled.mass_per_length *= mass_factor;
  PLUMB_CHOOSE(chain_system, scaled, elements, q, block_columns);
}

void add_up(int size, const double* first, int count, const double* factors, const double* const* terms,
            double* result) {
  constexpr int wide = 4;
  int i = 0;
  for (; i + wide * lanes <= size; i += wide * lanes) {
    Lanes sum[wide];
    for (int w = 0; w < wide; ++w) sum[w] = load_lanes(first + i + w * lanes);
    for (int k = 0; k < count; ++k)
      for (int w = 0; w < wide; ++w) sum[w] += factors[k] * load_lanes(terms[k] + i + w * lanes);
    for (int w = 0; w < wide; ++w) store_lanes(result + i + w * lanes, sum[w]);
  }
  for (; i + lanes <= size; i += lanes) {
    Lanes sum = load_lanes(first + i);
    for (int k = 0; k < count; ++k) sum += factors[k] * load_lanes(terms[k] + i);
    store_lanes(result + i, sum);
  }
  for (; i < size; ++i) {
    double sum = first[i];
    for (int k = 0; k < count; ++k) sum += factors[k] * terms[k][i];
    result[i] = sum;
  }
}

}  // namespace

extern const Kernels PLUMB_KERNELS;
const Kernels PLUMB_KERNELS{PLUMB_INSTRUCTION_SET, force,  energy,        system, factor, solve, mass_solve,
                            mass_multiply,         add_up, kinetic_energy};

}  // namespace plumb::kernels
