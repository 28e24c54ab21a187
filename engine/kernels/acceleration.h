#pragma once

#include "engine/kernels/mass_band.h"
#include "engine/kernels/summed_nodes.h"

namespace plumb::kernels {
namespace {

/// Kernels::acceleration: coordinates and the sums before are made as the forces ask for them, the sums after
/// as the solution comes back from the middle.
template <bool green, bool full>
int chain_acceleration(const ElementConstants& element, int elements, const MassFactors& mass,
                       const NodeForces& loads, const StageSums& sums, double* a) {
  const int unsound = chain_force<green, full>(element, elements, SummedNodes(sums.q, sums.before), a);
  loads.add_to(a);

  const int last_node = elements, middle = (elements + 1) / 2;
  MassSweep sweep(elements + 1, mass, a);
  sweep.inwards_to_middle();
  // Outwards by blocks, each of which is at hand when its sums are added up.
  constexpr int block = 64;
  int first = middle, last = middle - 1;  // the nodes that are done
  while (first > 0 || last < last_node) {
    const int next_first = first > block ? first - block : 0;
    const int next_last = last + block < last_node ? last + block : last_node;
    sweep.outwards_to(next_first, next_last);
    for (const Sum& sum : sums.after) {
      add_up(sum, next_first, first);
      add_up(sum, last + 1, next_last + 1);
    }
    first = next_first;
    last = next_last;
  }
  return unsound;
}

}  // namespace
}  // namespace plumb::kernels
