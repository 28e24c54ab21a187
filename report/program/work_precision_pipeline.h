#pragma once

#include <optional>

#include "engine/study/journal.h"
#include "report/program/run_pipeline.h"
#include "report/study/work_precision/work_precision_results.h"

/// The pieces of work on studies that the verbs are made of.
namespace plumb {

/// Makes the quick study of a case with a progress bar.
Study quick_study(const LoadedCase& loaded, Journal& journal, Console& console);

/// Writes study.h5.
void write_study(const Study& study, OutputFolder& folder);

/// The study that lies beside a run, if any. Throws InputError where it cannot be used.
std::optional<Study> study_beside(const std::string& run_path);

/// Reads a study from a path to its file or its folder. Throws InputError.
Study find_study(const std::string& path);

/// True for the path to a study.h5, or to a folder with one and no run.h5.
bool is_study(const std::string& path);

}  // namespace plumb
