#pragma once

#include <vector>

#include "engine/output/output_folder.h"
#include "engine/study/work_precision.h"
#include "report/pictures.h"

namespace plumb {

/// Draws the figures of a study into a folder: figures/*.png. Throws OutputError when drawing or writing
/// fails, Interrupted when the user stops it.
std::vector<Picture> draw_study(const WorkPrecision& study, OutputFolder& folder);

}  // namespace plumb
