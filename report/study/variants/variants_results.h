#pragma once

#include <string>
#include <vector>

#include "engine/study/variants/run_variants.h"
#include "report/study/study_report.h"

namespace plumb {

/// A verification for each variant that expects something: passed where outcome, message and all figures are
/// met. Its value is the greatest distance of a figure from the expected one as a share of its margin.
StudyReport evaluate_variants(const VariantsStudy& study, const Stages& stages);

/// The variants on their page, with these pictures.
StudySection shown_variants(const Variants& study, const std::vector<Picture>& pictures);

/// Whether a variant's run ended before its time.
bool ended_early(const VariantResult& variant);

/// What a variant is expected to do, in words: "unstable; end-time 1.2 ± 0.05 s".
std::string expected_in_words(const VariantResult& variant);
/// What it did: "unstable; end-time 1.2 s".
std::string found_in_words(const VariantResult& variant);

/// A number and its margin, to the same digits: "1.200 ± 0.005".
std::string with_margin(double value, double within);
/// A number to the digits of a margin, or to two where it is less than that; "none" where it is not finite.
std::string to_margin(double value, double within);

}  // namespace plumb
