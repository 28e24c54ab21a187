#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/study/uncertainty/uncertainty.h"
#include "engine/study/uncertainty/uncertainty_runs.h"

namespace plumb {

/// One column of a run at the times of a comparison, or why there is none.
struct ColumnValues {
  std::vector<double> values;
  std::string fault;
};

/// The part of the mesh, from a column on three meshes, the finest first. Where their order is none that the
/// elements can have, it is a bound: three times the greatest change to another mesh up to each time.
UncertaintyPart mesh_part(const ThreeMeshes& meshes, const std::array<ColumnValues, 3>& columns);

/// The part of time integration, from the run itself and a finer one.
UncertaintyPart time_part(const MethodSpec& method, const std::vector<double>& run,
                          const ColumnValues& finer);

/// The part of interpolation between the outputs of the run, from how far it may be off at each time, 0 at
/// outputs.
UncertaintyPart interpolation_part(const std::vector<double>& errors);

/// The part of so many inputs, sampled with a seed: at each time the standard deviation over the samples that
/// have a result.
UncertaintyPart input_part(std::size_t inputs, long seed, const std::vector<ColumnValues>& samples);

/// What an error of the computation behind a reference moves its numbers by.
struct DataError {
  std::string name;                ///< "time integration"
  std::vector<double> difference;  ///< at each time of the comparison, in the unit of the series
};

/// The part of the data at `count` times: what the reference states, and what is known of the errors of the
/// computation behind it, each as the greatest up to each time.
UncertaintyPart data_part(const ReferenceSeries& series, std::size_t count,
                          const std::vector<DataError>& errors = {});

/// The part of the mesh where the reference was computed on the same one.
UncertaintyPart shared_mesh_part(int elements);

/// Fills in what follows from times, error and parts.
void conclude(SeriesUncertainty& series);

}  // namespace plumb
