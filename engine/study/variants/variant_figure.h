#pragma once

#include <vector>

#include "engine/study/variants/variants.h"

namespace plumb {

/// What a finished variant, still with its states, shows of an expected figure. `all` are the variants that a
/// distance may be to.
ExpectationFound find_figure(const ExpectationSpec& expected, const VariantResult& variant,
                             const std::vector<VariantResult>& all);

/// The factor by which a vibration x grows from one sample to the next: the greatest root of z² − a z + b,
/// with x(k+1) = a x(k) − b x(k−1) + c fitted by least squares to the second half of the samples. Not a
/// number where there are too few, or they do not vibrate.
double growth_of(const std::vector<double>& samples);

}  // namespace plumb
