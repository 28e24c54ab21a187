#pragma once

#include <string>
#include <vector>

#include "engine/output/output_folder.h"
#include "report/pictures.h"
#include "report/study_results.h"

namespace plumb {

/// Writes the report of a study into a folder: index.html with the pictures it has, results.json, junit.xml
/// and summary.md. Returns what results.json holds. Throws OutputError.
std::string write_study_report(const StudyResults& results, const std::vector<Picture>& pictures,
                               OutputFolder& folder);

}  // namespace plumb
