#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "report/base/base64.h"
#include "report/base/escape.h"
#include "report/exports/run_curves.h"

namespace plumb {
namespace {

/// A piece of VTK's XML with its numbers in base64, behind their size in bytes.
template <class Number>
std::string data_array(const char* type, std::string_view name, std::string_view unit, int components,
                       const std::vector<Number>& numbers) {
  const std::uint64_t size = numbers.size() * sizeof(Number);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
  const std::string key =
      unit.empty()
          ? ""
          : fmt::format("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>",
                        unit);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" "
      "format=\"binary\">\n{}\n{}</DataArray>\n",
      type, name, components, numbers.size() / static_cast<std::size_t>(components), base64(bytes), key);
}

std::string poly_data(const RunCurves& curves, double time) {
  const CurveStep step = curves.at(time);
  std::vector<std::int64_t> connectivity, offsets, runs, ended(step.ended.begin(), step.ended.end());
  for (std::size_t k = 0; k < curves.points(); ++k) connectivity.push_back(static_cast<std::int64_t>(k));
  std::int64_t end = 0;
  for (const std::size_t count : curves.counts()) {
    runs.push_back(static_cast<std::int64_t>(runs.size()));
    offsets.push_back(end += static_cast<std::int64_t>(count));
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
  text += data_array<double>("Float64", "TimeValue", "s", 1, {time});
  text += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfLines=\"{}\">\n<Points>\n",
                      curves.points(), runs.size());
  text += data_array("Float64", "Points", "m", 3, step.points);
  text += "</Points>\n<Lines>\n" + data_array("Int64", "connectivity", "", 1, connectivity) +
          data_array("Int64", "offsets", "", 1, offsets) + "</Lines>\n<PointData>\n";
  for (std::size_t k = 0; k < curves.fields().size(); ++k) {
    const CurveField& field = curves.fields()[k];
    text += data_array("Float64", field.name, field.unit, field.components, step.values[k]);
  }
  text += "</PointData>\n<CellData>\n" + data_array("Int64", "run", "", 1, runs) +
          data_array("Int64", "ended", "", 1, ended);
  return text + "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

void write_vtp(const std::vector<ExportedRun>& runs, const PutFile& put) {
  const RunCurves curves(runs);
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  std::string labels;
  for (const ExportedRun& run : runs) labels += (labels.empty() ? "" : ", ") + run.label;
  for (std::size_t k = 0; k < curves.times().size(); ++k) {
    const std::string name = fmt::format("vtp/{:04}.vtp", k);
    put(name, poly_data(curves, curves.times()[k]));
    collection +=
        fmt::format("<DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\" name=\"{}\"/>\n",
                    curves.times()[k], name, escape_xml(labels));
  }
  put("run.pvd", collection + "</Collection>\n</VTKFile>\n");
}

}  // namespace

ExportFormat vtp_export() {
  return {.name = "vtp",
          .file = "run.pvd",
          .summary = "run.pvd and one XML file a time in vtp/, for any ParaView and VTK",
          .many_files = true,
          .write = write_vtp};
}

}  // namespace plumb
