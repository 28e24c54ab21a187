#pragma once

#include <vector>

#include "engine/run/output_folder.h"
#include "engine/study/work_precision/work_precision.h"
#include "report/figure/pictures.h"

namespace plumb {

/// Draws the figures of a study into a folder: figures/*.png. Throws OutputError when drawing or writing
/// fails, Interrupted when the user stops it.
std::vector<Picture> draw_study(const WorkPrecision& study, OutputFolder& folder);

}  // namespace plumb
