#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/study/reference/mesh_index.h"

namespace plumb {

/// A case that is to be integrated for an estimate.
struct PlannedRun {
  Case spec;
  std::string fault;  ///< why there is no such case; empty: there is
};

/// Three meshes, the finest first, and which of them the case has.
struct ThreeMeshes {
  std::array<int, 3> elements{};
  OfThree of = OfThree::coarsest;
};

/// N, N/2 and N/4 elements where N/4 is whole and at least 4, else 4N, 2N and N: of fewer the changes follow
/// no order.
ThreeMeshes three_meshes(int elements);

/// The case with a cheap method that is exact in time beside what meshes and inputs do:
/// classical_explicit() at a quarter of its limit of stability on the finest mesh asked of it, or the case's
/// own method where nothing moves.
Case exact_in_time(const Case& spec);

/// The case with half its step or a tenth of its tolerances. `fault` says where it has neither.
PlannedRun finer_in_time(const Case& spec);

/// How much finer, and the order by which that counts: 2 and the method's for a step, 10 and 1 for
/// tolerances.
struct Refinement {
  double ratio = 2;
  double order = 1;
};
Refinement refinement_of(const MethodSpec& method);

/// The case once for each sample of some uncertain inputs, by a Latin hypercube, exact in time with one step
/// for all. `texts` says of each what was sampled.
struct PlannedSamples {
  std::vector<PlannedRun> runs;
  std::vector<std::string> texts;
};
PlannedSamples planned_samples(const LoadedCase& loaded, const std::vector<UncertainInput>& inputs);

}  // namespace plumb
