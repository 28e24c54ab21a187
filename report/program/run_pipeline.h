#pragma once

#include <string>

#include "engine/run/output_folder.h"
#include "engine/run/run.h"
#include "report/document/document.h"
#include "report/figure/pictures.h"
#include "report/program/console.h"
#include "report/program/drawing_beside.h"
#include "report/program/options.h"
#include "report/verdict/results.h"

/// The pieces of work that the verbs are made of.
namespace plumb {

/// Reads the case of the command line and says what was noteworthy. Throws InputError.
LoadedCase load(const Options& options, Console& console, const SectionUse& uses = use_all);

/// Says what is implausible in a case. For after its estimate, as a vibration is found for it on all of the
/// mesh.
void remark_on_inputs(const Case& spec, Console& console);

/// Integrates a case and takes down what it was done with; says how it went.
Run solve(const LoadedCase& loaded, Console& console);

/// The same, or the external run of a case without [method].
Run solve_or_take(const LoadedCase& loaded, Console& console);

/// Throws UsageError for a case without [method], of which nothing can be solved.
void refuse_without_method(const LoadedCase& loaded);

/// The folder for a case's results: that of -o, or output/ and the case file's name.
std::string output_path(const Options& options, const LoadedCase& loaded);

/// Reads a run from a path to its file or its folder. Throws InputError.
Run find_run(const std::string& path);

/// The folder for what is made from a run: that of -o, or the one that the run lies in. Throws UsageError for
/// a run file of another name than run.h5 without -o, as it is no part of the folder it lies in.
std::string output_path_of_run(const Options& options);

/// Takes down in the run's provenance what draws its pictures, as try_drawing() gave it.
void note_renderer(Run& run, const std::string& fingerprint);

/// Writes run.h5 and probes.csv.
void write_run(const Run& run, OutputFolder& folder);

/// Says the verdicts, the headline and where the report is; with --json prints the document.
void say_report(const Document& document, const std::string& folder, const Options& options,
                Console& console);

/// 0, 1 or 4 by how the run ended and its verdicts; 1 where one that was given is known to have failed.
ExitStatus status_of(const Document& document);

void say_verdicts(const std::vector<Verdict>& verdicts, Console& console);

/// Draws with a progress bar: the figures of a run, and all frames of a scene or those of a range.
Pictures draw_pictures(const Run& run, const SceneOfRun& scene, const std::optional<FrameRange>& range,
                       DrawingTools& tools, OutputFolder& folder, Stages& stages, Console& console);

/// All that follows a run: pictures, verdicts and report, with the folder put in place and the verdicts said.
/// Where pictures cannot be drawn the folder is put in place without them, and then OutputError is thrown.
/// `begun`: what draws them already.
ExitStatus draw_and_report(const Run& run, const std::vector<RunSection>& sections, OutputFolder& folder,
                           Stages& stages, const Options& options, Console& console,
                           DrawingBeside* begun = nullptr);

/// `plumb run` of one case.
ExitStatus run_one(const Options& options, Console& console);

/// Says where the time went, and the peak memory.
void say_stages(const Stages& stages, Console& console);

}  // namespace plumb
