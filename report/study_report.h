#pragma once

#include <string>

#include "engine/output/output_folder.h"
#include "report/study_results.h"

namespace plumb {

/// Writes the report of a study into a folder: results.json, junit.xml and summary.md. Returns what
/// results.json holds. Throws OutputError.
std::string write_study_report(const StudyResults& results, OutputFolder& folder);

}  // namespace plumb
