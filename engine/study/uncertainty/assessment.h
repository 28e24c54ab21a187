#pragma once

#include <optional>
#include <string>

#include "engine/run/run.h"
#include "engine/study/uncertainty/error_budget.h"
#include "engine/study/uncertainty/uncertainty.h"

namespace plumb {

/// What was computed beside a run to say how far its comparisons can be trusted. Each is there where the case
/// asks for it.
struct Assessment {
  std::optional<Uncertainty> uncertainty;
  std::optional<ErrorBudget> error_budget;

  bool empty() const { return !uncertainty && !error_budget; }
};

/// Version of assessment.json; a reader refuses another one.
inline constexpr int assessment_version = 2;

/// assessment.json, which lies beside run.h5.
std::string encode_assessment(const Assessment& assessment);

/// Reads it back. Throws InputError, naming `file`, for anything that encode_assessment() does not write, and
/// for the assessment of another run: one of other series, or with other comparison errors.
Assessment decode_assessment(const std::string& text, const std::string& file, const Run& run);

}  // namespace plumb
