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

/// The part of the mesh, from a column on three meshes, the finest first.
UncertaintyPart mesh_part(const ThreeMeshes& meshes, const std::array<ColumnValues, 3>& columns);

/// The part of time integration, from the run itself and a finer one.
UncertaintyPart time_part(const MethodSpec& method, const std::vector<double>& run,
                          const ColumnValues& finer);

/// The part of interpolation between the outputs of the run, from how far it may be off at each time, 0 at
/// outputs.
UncertaintyPart interpolation_part(const std::vector<double>& errors);

/// The part of the inputs: at each time the standard deviation over the samples that have a result.
UncertaintyPart input_part(const InputSampling& sampling, const std::vector<ColumnValues>& samples);

/// The part of the data: one number for all `count` times.
UncertaintyPart data_part(const ReferenceSeries& series, std::size_t count);

/// Fills in what follows from times, error and parts.
void conclude(SeriesUncertainty& series);

}  // namespace plumb
