#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "report/exports/export_formats.h"
#include "report/figure/other_runs.h"
#include "report/program/output_use.h"
#include "report/program/print_json.h"
#include "report/program/run_pipeline.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

std::vector<ExportedRun> runs_of(const Options& options, Console& console) {
  std::vector<ExportedRun> runs;
  const std::vector<std::string> labels = labels_of_runs(options.inputs);
  for (std::size_t k = 0; k < options.inputs.size(); ++k) {
    runs.push_back({labels[k], find_run(options.inputs[k])});
    const Trajectory& trajectory = runs.back().run.trajectory;
    if (trajectory.outcome != Outcome::completed)
      console.remark(fmt::format("{} did not complete: it is exported up to {:.10g} s", options.inputs[k],
                                 trajectory.end_time));
  }
  return runs;
}

ExitStatus do_export(const Options& options, Console& console) {
  const ExportFormat& format = export_format(options.to);
  if (options.output.empty() && options.inputs.size() > 1)
    throw UsageError("several runs in one file belong to no folder of a run: -o says where it goes");
  const std::vector<ExportedRun> runs = runs_of(options, console);
  std::string place;
  if (!options.output.empty() && !format.many_files) {
    std::vector<std::string> reads;
    for (const std::string& path : options.inputs)
      for (const std::string& file : source_files(path)) reads.push_back(file);
    refuse_to_overwrite("-o", options.output, reads);
    place = options.output;
    format.write(runs, [&](const std::string&, std::string_view bytes) { write_file(place, bytes); });
  } else {
    FolderUse use = folder_from(options.input, console);
    use.adds = options.output.empty();
    OutputFolder folder(output_path_of_run(options), use);
    format.write(runs, [&](const std::string& name, std::string_view bytes) { folder.write(name, bytes); });
    folder.commit();
    place = (std::filesystem::path(folder.path()) / format.file).string();
  }
  console.line(fmt::format("{}: {}", format.name, place));
  if (options.json) print_json({{"format", format.name}, {"file", place}, {"runs", runs.size()}});
  return ExitStatus::done;
}

}  // namespace

Verb export_verb() {
  return {.name = "export",
          .summary = "finished runs for other programs: ParaView, Blender, browsers",
          .act = do_export,
          .input = "RUN",
          .takes_many = true,
          .takes_output = true,
          .exports = true};
}

}  // namespace plumb
