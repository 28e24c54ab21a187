#pragma once

#include <string>

#include "engine/case/reference.h"
#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// What E and k u over all times of a series say: "not distinguishable at any of 101 times", or at how many
/// they are, from when to when, and between which bounds the error is where it is clearest. What a part that
/// is not estimated leaves open is said. Published references tell of the model, computed ones of the
/// numerical solution alone. `beyond`, `error` and `validation` are to be known.
std::string comparison_finding(const SeriesUncertainty& series);

/// How the half width that a reference states was made a standard uncertainty.
struct DataUncertainty {
  double standard = 0;  ///< in the unit of the series
  std::string how;
};

/// Bounds of a uniform distribution (JCGM 100:2008, 4.3.7): half width over √3. Says where the half width is
/// the greatest that rounding can do, and where its coverage is only taken to be whole.
DataUncertainty data_uncertainty(const ReferenceSeries& series);

}  // namespace plumb
