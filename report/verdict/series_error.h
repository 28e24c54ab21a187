#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/run/run.h"
#include "report/verdict/coverage.h"

namespace plumb {

/// What a limit on a distance must be small against to say anything.
struct Magnitude {
  double size = 0;   ///< greatest |value|; 0: nothing is known
  double reach = 0;  ///< greatest distance of two values of one series

  /// Takes in one more series.
  void add(const std::vector<double>& values);
};

/// How far the printed figures of a comparison are from the exact ones.
struct PrintError {
  double max = 0;          ///< greatest |printed − exact|, in the unit of the series
  double max_time = 0;     ///< s, where it is
  double rms = 0;          ///< over the times that are compared
  double greatest = 0;     ///< greatest |exact|
  double uncertainty = 0;  ///< of the exact ones, half-width
};

/// How far one column of a run is from one series of a reference. Distances are in `unit`, run minus
/// reference.
struct SeriesError {
  std::optional<std::size_t> given_run;  ///< which [[run]] of the case; nothing: the run that is reported
  std::size_t reference = 0;             ///< which [[reference]] of the case
  bool exact = false;                    ///< against Reference::exact, not against what it gives as printed
  std::optional<PrintError> print;       ///< of what is printed where there are exact figures, else none
  std::string series;                    ///< "mid_y"
  std::string column;                    ///< "mid.y"
  std::string unit;
  Coverage coverage;
  std::vector<double> times;       ///< s, the reference times that are compared
  std::vector<double> expected;    ///< of the reference, at those times
  std::vector<double> difference;  ///< run − reference, at those times
  double max = 0;                  ///< greatest |difference|
  double max_time = 0;             ///< s, where it is
  double rms = 0;
  /// Of all that is compared with the reference in that unit, at the claimed times; where that is 0
  /// throughout, of positions the length of the cable.
  Magnitude scale;
};

/// The errors of every comparison of the case, in its order, that against exact figures after that against
/// the printed ones: those of the run that is reported, and then those of each external run beside it.
std::vector<SeriesError> series_errors(const Run& run);

/// A run at times (s): that which is reported, or the k-th given one.
SampledRun sample_of(const Run& run, std::optional<std::size_t> given_run, const std::vector<double>& times);

/// The outputs (s) of the same.
const std::vector<double>& outputs_of(const Run& run, std::optional<std::size_t> given_run);

/// What a run is called: "Plumb", or the name of a given one.
std::string run_name(const Run& run, std::optional<std::size_t> given_run);

/// Why a run vouches for nothing: "the run ended early, unstable at 0.3 s"; empty where it does.
std::string failure_of(const Run& run, std::optional<std::size_t> given_run);

/// "" for the run that is reported, else the name of the given one.
std::string given_name(const SeriesError& error, const Case& spec);

/// Greatest |difference|, when it is, and the root of the mean of squares. A difference that is not a number
/// makes them not a number, so that nothing passes.
struct DifferenceNorms {
  double max = 0;
  double max_time = 0;
  double rms = 0;
};
DifferenceNorms norms_of(const std::vector<double>& times, const std::vector<double>& difference);

}  // namespace plumb
