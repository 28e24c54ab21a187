#pragma once

#include <string>

#include "engine/case/case_source.h"
#include "engine/study/stability/stability.h"

namespace plumb {

/// A stability study with the case it was made of.
struct StabilityStudyFile {
  LoadedCase loaded;
  Stability result;
};

/// The kind that study.json names.
inline constexpr const char* stability_kind = "stability";

/// The text of study.json: kind, version, the case with its references as they were read, and all of the
/// result.
std::string encode_stability(const StabilityStudyFile& study);

/// The study in such a text; `name` is that of the file, for errors. Throws InputError where the text is
/// damaged, of another kind or of a later version, or the case in it is invalid.
StabilityStudyFile decode_stability(const std::string& text, const std::string& name);

}  // namespace plumb
