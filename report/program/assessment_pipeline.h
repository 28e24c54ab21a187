#pragma once

#include <string>

#include "engine/run/output_folder.h"
#include "engine/study/journal.h"
#include "engine/study/uncertainty/assessment.h"
#include "report/base/stages.h"
#include "report/program/console.h"

/// The pieces of work on a run's uncertainty and error budget that the verbs are made of.
namespace plumb {

/// Computes what the case of a run asks for, with a progress bar.
Assessment assess(const Run& run, Journal& journal, Stages& stages, Console& console);

/// Writes assessment.json, where there is anything to write.
void write_assessment(const Assessment& assessment, OutputFolder& folder);

/// The assessment that lies beside a run; empty where there is none. Throws InputError where it cannot be
/// used.
Assessment assessment_beside(const std::string& run_path, const Run& run);

}  // namespace plumb
