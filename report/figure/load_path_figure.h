#pragma once

#include "report/figure/figures.h"

namespace plumb {

/// The load over the displacement along the path of equilibria of statics, its stable and unstable parts told
/// apart, with its critical points and the outputs. Only of a run that has such a path.
Figure load_path_figure(const Run& run);

}  // namespace plumb
