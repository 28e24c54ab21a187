#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "report/figure/figures.h"

namespace plumb {

/// A figure that every run has.
struct RunFigure {
  std::string_view name;  ///< of the file, without its ending; no [[figure]] of a case may have it
  /// Of a run with states. Nothing where there is no finite value to show; the name is set by who asks.
  std::optional<Figure> (*draw)(const Run& run);
  bool of_modes = false;  ///< of a run of modes, and of no other
};

/// All of them in order. A new one has a file of its own, and its line in run_figures.cpp.
std::span<const RunFigure> run_figures();

/// Throws InputError, with its place in the file, for a [[figure]] of a case that has the name of one of
/// them.
void refuse_names_of_run_figures(const LoadedCase& loaded);

}  // namespace plumb
