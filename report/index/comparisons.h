#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// The comparisons of a report as pairs of a reference's value and a predicted one, for `comparisons[]` of an
/// index: of each series where the reference is greatest, and where the prediction is farthest from it, but
/// for the start where there is more.
Document comparisons_of(const Document& report, const std::string& folder);

/// True for a pair that has a logarithm of its ratio: both of one sign, finite, and not 0.
bool has_ratio(const Document& reference, const Document& predicted);

/// Bias and spread of each kind of comparisons ("validation", "verification", "another model"), after
/// K. McGrattan and B. Toman, "Quantifying the predictive uncertainty of complex numerical models",
/// Metrologia 48 (2011) 173–180, as in the FDS Validation Guide, NIST Special Publication 1018-3,
/// "Calculating Model Uncertainty". Of n pairs of a predicted value M and that of the reference, E, at its
/// greatest:
///
///   m = Σ ln(M/E) / n,   s² = Σ (ln(M/E) − m)² / (n − 1),   σ_E² = mean of (u/E)², at most s²/2,
///   σ_M² = s² − σ_E²,    bias = exp(m + σ_M²/2 − σ_E²/2),
///
/// where u is the half width that the reference states over √3, as of a uniform distribution. A prediction
/// cannot be shown to scatter less than what it is held against, hence the s²/2.
Document statistics_of(const Document& comparisons);

}  // namespace plumb
