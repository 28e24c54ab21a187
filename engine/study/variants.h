#pragma once

#include <string>
#include <vector>

#include "engine/input/case.h"
#include "engine/integrate/trajectory.h"
#include "engine/output/probes.h"
#include "engine/output/provenance.h"

namespace plumb {

/// An expectation beside what was found.
struct ExpectationFound {
  ExpectationSpec expected;
  std::string unit;
  double found = 0;  ///< not a number: the run does not have it
  bool met() const {
    return found - expected.value <= expected.within && expected.value - found <= expected.within;
  }
};

/// A variant of a case as it went.
struct VariantResult {
  VariantSpec spec;
  Case run;  ///< what was integrated
  Trajectory trajectory;
  ProbeTable probes;
  std::vector<ExpectationFound> expectations;
  bool outcome_met() const { return spec.outcome.empty() || spec.outcome == word(trajectory.outcome); }
};

/// All variants of a case: each a failure that is known, beside what is known of it.
struct Variants {
  std::string title;
  std::vector<VariantResult> variants;
  Provenance provenance;
};

}  // namespace plumb
