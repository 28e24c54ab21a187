#pragma once

#include <string>

#include "engine/study/sensitivity/sensitivity.h"

namespace plumb {

/// The text of a study.json of the kind "sensitivity", which is also the sensitivity.json beside a run.
std::string encode_sensitivity(const SensitivityStudy& study);

/// Reads it back, and its case again from the texts it holds. Throws InputError, naming `file`, for anything
/// that encode_sensitivity() does not write.
SensitivityStudy decode_sensitivity(const std::string& text, const std::string& file);

}  // namespace plumb
