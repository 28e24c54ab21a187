#pragma once

#include <string>

#include "engine/output/output_folder.h"
#include "engine/output/run.h"
#include "report/pictures.h"
#include "report/program/options.h"
#include "report/program/talk.h"
#include "report/results.h"

/// The pieces of work that the verbs are made of.
namespace plumb {

/// Reads the case of the command line and says what was noteworthy. Throws InputError.
LoadedCase load(const Options& options, Talk& talk);

/// Integrates a case and takes down what it was done with; says how it went.
Run solve(const LoadedCase& loaded, Talk& talk);

/// The folder for a case's results: that of -o, or output/ and the case file's name.
std::string output_path(const Options& options, const LoadedCase& loaded);

/// A run with the folder it lies in.
struct FoundRun {
  Run run;
  std::string folder;
};

/// Reads a run from a path to its file or its folder. Throws InputError.
FoundRun find_run(const std::string& path);

/// Writes run.h5 and probes.csv.
void write_run(const Run& run, OutputFolder& folder);

/// Draws with a progress bar.
Pictures draw_pictures(const Run& run, OutputFolder& folder, Stages& stages, Talk& talk);

/// Writes index.html, results.json, junit.xml and summary.md; returns what results.json holds.
std::string write_report(const Results& results, const Pictures& pictures, OutputFolder& folder);

void say_verdicts(const Results& results, Talk& talk);
/// Says where the time went, and the peak memory.
void say_stages(const Stages& stages, Talk& talk);

/// 0, 1 or 4 by outcome and verdicts.
ExitStatus status_of(const Results& results);

}  // namespace plumb
