#pragma once

#include "engine/run/output_folder.h"
#include "report/program/console.h"
#include "report/program/options.h"
#include "report/study/study_report.h"

/// How every kind of study ends.
namespace plumb {

/// Writes index.html and a file of each format, puts the folder in place and ends the stage.
/// Throws OutputError.
void put_in_place(const StudyReport& report, const StudySection& section, OutputFolder& folder,
                  Stages& stages);

/// Says the headline, where the time went and where the report is; with --json prints results.json. The exit
/// status is that of the verdicts, or that of a solver that failed where nothing could be run.
ExitStatus say_end(const StudyReport& report, const OutputFolder& folder, const Stages& stages,
                   const Options& options, Talk& talk);

}  // namespace plumb
