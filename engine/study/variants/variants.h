#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"
#include "engine/run/probes.h"
#include "engine/run/provenance.h"

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
  Case run;               ///< what was integrated
  Trajectory trajectory;  ///< without states, which only the figures need
  ProbeTable probes;
  std::vector<ExpectationFound> expectations;

  bool outcome_met() const {
    return (spec.outcome.empty() || spec.outcome == word(trajectory.outcome)) &&
           trajectory.message.find(spec.says) != std::string::npos;
  }
  /// The outcome and every figure.
  bool met() const;
};

/// All variants of a case: each a failure that is known, beside what is known of it.
struct Variants {
  std::string title;
  std::vector<VariantResult> variants;
  Provenance provenance;
};

}  // namespace plumb
