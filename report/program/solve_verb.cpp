#include <nlohmann/json.hpp>
#include <optional>

#include "engine/base/file_writing.h"
#include "engine/run/mode_table.h"
#include "report/document/case_json.h"
#include "report/program/limits.h"
#include "report/program/output_use.h"
#include "report/program/print_json.h"
#include "report/program/run_pipeline.h"
#include "report/program/scene_choice.h"
#include "report/program/verbs.h"
#include "report/study/economy/economy_section.h"

namespace plumb {
namespace {

ExitStatus do_solve(const Options& options, Console& console) {
  Stages stages;
  stages.begin("reading");
  const LoadedCase given =
      load(options, console, [&](std::string_view section) { return options.economy && section == "scene"; });
  refuse_without_method(given);
  const bool writes_run = options.csv.empty() || !options.output.empty();
  check_estimate(given.spec, {.solves = true, .writes_run = writes_run, .writes_table = !options.csv.empty()},
                 given.source.file.name, output_path(options, given), options, console);
  remark_on_inputs(given.spec, console);
  std::optional<SceneChoice> choice;
  if (is_left_to_scene(given, options))
    choice = choose_for_scene(given, output_path(options, given), options, console);
  const LoadedCase& loaded = choice ? choice->loaded : given;
  std::optional<OutputFolder> folder;
  FolderUse use = folder_for(given, options, console);
  if (writes_run) {
    use.content = FolderContent::run;
    folder.emplace(output_path(options, loaded), use);
  }
  if (!options.csv.empty() && options.csv != "-")
    refuse_to_overwrite("--csv", options.csv, use.reads, folder ? folder->path() : "");
  stages.begin(solving_stage);
  const Run run = solve(loaded, console);
  stages.begin("writing the run");
  if (folder) {
    write_run(run, *folder);
    folder->commit();
    console.line("run: " + folder->path() + "/run.h5");
  }
  const std::string table = has_modes(run) ? modes_csv(run.trajectory, run.modes) : to_csv(run.probes);
  if (options.csv == "-") {
    write_to_standard_output(table);
  } else if (!options.csv.empty()) {
    write_file(options.csv, table);
    console.line((has_modes(run) ? "modes: " : "probes: ") + options.csv);
  }
  if (options.json) {
    nlohmann::ordered_json json = solve_json(run);
    if (has_modes(run)) json[std::string(modes_key)] = modes_json(run);
    if (choice)
      for (const RunSection& section : economy_sections(run, choice->economy))
        json[section.key] = section.json;
    print_json(json);
  }
  if (run.trajectory.outcome != Outcome::completed) return ExitStatus::solver_failed;
  return choice && !choice->economy.holds ? ExitStatus::criterion_not_met : ExitStatus::done;
}

}  // namespace

Verb solve_verb() {
  return {.name = "solve",
          .summary = "integrate only: run.h5 and probes.csv",
          .act = do_solve,
          .input = "CASE",
          .takes_overrides = true,
          .takes_output = true,
          .takes_csv = true,
          .chooses = true,
          .is_estimated = true};
}

}  // namespace plumb
