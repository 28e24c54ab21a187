#pragma once

#include "engine/study/work_precision/work_precision_file.h"
#include "report/study/made_study.h"

namespace plumb {

/// The file that a study of work and precision is kept in.
inline constexpr const char* study_file_name = "study.h5";

std::unique_ptr<MadeStudy> made_study(Study study);

}  // namespace plumb
