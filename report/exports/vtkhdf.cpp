#include "engine/base/hdf5.h"
#include "report/exports/run_curves.h"

namespace plumb {
namespace {

constexpr unsigned char polyline = 4;  // of VTK's types of cells

/// A transient unstructured grid of VTKHDF 2.0: points and fields of all steps one after another, and for
/// each step where its own begin. The curves' topology is there once.
void write_vtkhdf(const std::vector<ExportedRun>& runs, const PutFile& put) {
  const RunCurves curves(runs);
  const auto points = static_cast<long>(curves.points()), cells = static_cast<long>(curves.counts().size());
  const auto steps = static_cast<hsize_t>(curves.times().size());
  std::vector<double> places;
  std::vector<std::vector<double>> values(curves.fields().size());
  std::vector<long> ended;
  for (const double time : curves.times()) {
    CurveStep step = curves.at(time);
    places.insert(places.end(), step.points.begin(), step.points.end());
    ended.insert(ended.end(), step.ended.begin(), step.ended.end());
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k].insert(values[k].end(), step.values[k].begin(), step.values[k].end());
  }

  hdf5::Writer file;
  file.integers("VTKHDF/NumberOfPoints", {points});
  file.integers("VTKHDF/NumberOfCells", {cells});
  file.integers("VTKHDF/NumberOfConnectivityIds", {points});
  std::vector<long> connectivity, offsets{0}, numbers;
  for (long k = 0; k < points; ++k) connectivity.push_back(k);
  for (const std::size_t count : curves.counts()) {
    numbers.push_back(static_cast<long>(numbers.size()));
    offsets.push_back(offsets.back() + static_cast<long>(count));
  }
  file.integers("VTKHDF/Connectivity", connectivity);
  file.integers("VTKHDF/Offsets", offsets);
  file.bytes("VTKHDF/Types", std::string(static_cast<std::size_t>(cells), static_cast<char>(polyline)));
  file.numbers("VTKHDF/Points", {steps * static_cast<hsize_t>(points), 3}, places.data(), "m");
  file.integers("VTKHDF/CellData/run", numbers);
  file.integers("VTKHDF/CellData/ended", ended);

  const std::vector<long> none(steps, 0), one(steps, 1);
  std::vector<long> at_point, at_cell;
  for (hsize_t k = 0; k < steps; ++k) {
    at_point.push_back(static_cast<long>(k) * points);
    at_cell.push_back(static_cast<long>(k) * cells);
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    const CurveField& field = curves.fields()[k];
    std::vector<hsize_t> shape{steps * static_cast<hsize_t>(points)};
    if (field.components > 1) shape.push_back(static_cast<hsize_t>(field.components));
    const std::string name(field.name);
    file.numbers("VTKHDF/PointData/" + name, shape, values[k].data(), field.unit);
    file.integers("VTKHDF/Steps/PointDataOffsets/" + name, at_point);
  }
  file.numbers("VTKHDF/Steps/Values", {steps}, curves.times().data(), "s");
  file.integers("VTKHDF/Steps/PartOffsets", none);
  file.integers("VTKHDF/Steps/NumberOfParts", one);
  file.integers("VTKHDF/Steps/PointOffsets", at_point);
  for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"})
    file.integers(std::string("VTKHDF/Steps/") + name, none, {steps, 1});
  file.integers("VTKHDF/Steps/CellDataOffsets/run", none);
  file.integers("VTKHDF/Steps/CellDataOffsets/ended", at_cell);
  file.attribute("VTKHDF", "Version", {2, 0});
  file.attribute("VTKHDF", "Type", "UnstructuredGrid");
  file.attribute("VTKHDF/Steps", "NSteps", static_cast<long>(steps));
  // What VTK has no place for.
  std::vector<std::string> labels, titles;
  for (const ExportedRun& run : runs) {
    labels.push_back(run.label);
    titles.push_back(run.run.loaded.spec.title);
  }
  file.texts("plumb/runs", labels);
  file.texts("plumb/titles", titles);
  put("run.vtkhdf", file.bytes());
}

}  // namespace

ExportFormat vtkhdf_export() {
  return {.name = "vtkhdf",
          .file = "run.vtkhdf",
          .summary = "one file with all times and fields, for ParaView 5.12 and VTK 9.3 and later",
          .write = write_vtkhdf};
}

}  // namespace plumb
