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

/// The loop of add_up for a number of terms that is known, so that their factors stay in registers.
template <int count>
void add_up_terms(int size, const double* first, const double* factors, const double* const* terms,
                  double* result) {
  Lanes factor[count];
  const double* term[count];
#pragma GCC unroll 8
  for (int k = 0; k < count; ++k) {
    factor[k] = all(factors[k]);
    term[k] = terms[k];
  }
  for (int i = 0; i < size; i += 6) {
    Six sum = load_six(first + i);
#pragma GCC unroll 8
    for (int k = 0; k < count; ++k) {
      const Six x = load_six(term[k] + i);
      sum.a += factor[k] * x.a;
      sum.b += __builtin_shufflevector(factor[k], factor[k], 0, 1) * x.b;
    }
    store_six(result + i, sum);
  }
}

void add_up(int size, const double* first, int count, const double* factors, const double* const* terms,
            double* result) {
  // Called by pointers, as the compiler would otherwise merge them and save registers for the largest.
  static constexpr decltype(&add_up_terms<1>) of_count[] = {add_up_terms<1>, add_up_terms<2>, add_up_terms<3>,
                                                            add_up_terms<4>, add_up_terms<5>, add_up_terms<6>,
                                                            add_up_terms<7>, add_up_terms<8>};
  constexpr int most = static_cast<int>(sizeof(of_count) / sizeof(of_count[0]));
  for (; count > most; count -= most, factors += most, terms += most, first = result)
    of_count[most - 1](size, first, factors, terms, result);
  of_count[count - 1](size, first, factors, terms, result);
}

}  // namespace

extern const Kernels PLUMB_KERNELS;
const Kernels PLUMB_KERNELS{PLUMB_INSTRUCTION_SET, force,  energy,        system, factor, solve, mass_solve,
                            mass_multiply,         add_up, kinetic_energy};

}  // namespace plumb::kernels
