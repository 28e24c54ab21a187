#pragma once

#include <string>

#include "engine/case/reference.h"

namespace plumb {

/// What |E| beside k u says, u the validation uncertainty: "not distinguishable at this uncertainty", or
/// between which bounds the error is. `whole` is false where a part of u is not estimated, so that it may be
/// greater. `published` references tell of the model, computed ones of the numerical solution alone.
std::string comparison_finding(double error, double expanded, const std::string& unit, bool published,
                               bool whole);

/// How the half width that a reference states was made a standard uncertainty.
struct DataUncertainty {
  double standard = 0;  ///< in the unit of the series
  std::string how;
};

/// Bounds of a uniform distribution (JCGM 100:2008, 4.3.7): half width over √3. Says where the half width is
/// the greatest that rounding can do, and where its coverage is only taken to be whole.
DataUncertainty data_uncertainty(const ReferenceSeries& series);

}  // namespace plumb
