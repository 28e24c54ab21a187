#pragma once

#include <string>
#include <vector>

#include "engine/study/variants/run_variants.h"
#include "report/base/stages.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// Everything the report of variants says, apart from how it looks.
struct VariantsResults {
  const VariantsStudy& study;
  std::vector<Verdict> verdicts;  ///< one for each variant that expects something
  Stages stages;                  ///< those before the report itself
};

/// A verification for each variant that expects something: passed where outcome, message and all figures are
/// met. Its value is the greatest distance of a figure from the expected one as a share of its margin.
VariantsResults evaluate_variants(const VariantsStudy& study, const Stages& stages);

/// What a variant is expected to do, in words: "unstable; end-time 1.2 ± 0.05 s".
std::string expected_in_words(const VariantResult& variant);
/// What it did: "unstable; end-time 1.2 s".
std::string found_in_words(const VariantResult& variant);

/// A number and its margin, to the same digits: "1.200 ± 0.005".
std::string with_margin(double value, double within);
/// A number to the digits of a margin, or to two where it is less than that; "none" where it is not finite.
std::string to_margin(double value, double within);

/// How the variants ended, and which of them not as expected, in words.
std::string headline(const VariantsResults& results);

/// results.json, junit.xml and summary.md.
std::string to_json(const VariantsResults& results);
std::string to_junit(const VariantsResults& results);
std::string to_summary(const VariantsResults& results);

}  // namespace plumb
