#pragma once

#include "engine/run/output_folder.h"
#include "report/base/stages.h"
#include "report/program/console.h"
#include "report/program/options.h"
#include "report/study/made_study.h"

namespace plumb {

/// Writes the report of a study with its file and figures, puts the folder in place, and says what was found,
/// where the time went and where the report is; with --json prints results.json. The exit status is that of
/// the verdicts, or that of a solver that failed where nothing could be run. Throws OutputError.
ExitStatus report_on(const MadeStudy& study, OutputFolder& folder, Stages& stages, const Options& options,
                     Console& console);

}  // namespace plumb
