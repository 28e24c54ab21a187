#include "report/figure/run_figures.h"

#include <fmt/format.h>

#include "engine/read/override.h"

namespace plumb {

#define PLUMB_RUN_FIGURES(figure) \
  figure(energy) figure(tension_range) figure(curvature_range) figure(strain_map) figure(load_path)

#define PLUMB_MODE_FIGURES(figure) figure(mode_shapes)

#define PLUMB_DECLARE(name) std::optional<Figure> name##_figure(const Run& run);
PLUMB_RUN_FIGURES(PLUMB_DECLARE)
PLUMB_MODE_FIGURES(PLUMB_DECLARE)
#undef PLUMB_DECLARE

std::span<const RunFigure> run_figures() {
#define PLUMB_LIST(name) RunFigure{#name, name##_figure},
#define PLUMB_LIST_OF_MODES(name) RunFigure{#name, name##_figure, true},
  static constexpr RunFigure all[] = {PLUMB_RUN_FIGURES(PLUMB_LIST) PLUMB_MODE_FIGURES(PLUMB_LIST_OF_MODES)};
#undef PLUMB_LIST
#undef PLUMB_LIST_OF_MODES
  return all;
}

void refuse_names_of_run_figures(const LoadedCase& loaded) {
  for (std::size_t k = 0; k < loaded.spec.figures.size(); ++k)
    for (const RunFigure& figure : run_figures())
      if (loaded.spec.figures[k].name == figure.name)
        refuse_key(loaded.source, fmt::format("figure.{}.name", k),
                   "is the name of a figure that every run has");
}

}  // namespace plumb
