#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/case/case_source.h"

namespace plumb {

/// What every study.json has: its kind, the version of its form, the case that it was made of, and beside
/// these, in `body`, what its kind found.
struct StudyRecord {
  LoadedCase loaded;
  nlohmann::ordered_json body;
};

/// The sections of a case that a kind of study makes something of: its own, and the scene.
SectionUse uses_of_study(std::string_view kind);

/// The text of study.json, with its check sum.
std::string encode_study_record(const char* kind, int version, const CaseSource& source,
                                const nlohmann::ordered_json& body);

/// Reads it back, and its case again from the texts. Throws InputError, naming `file`, for a text that is
/// damaged, of another kind, of a version beyond `version` or before `oldest`, or whose case is invalid.
StudyRecord decode_study_record(const std::string& text, const std::string& file, const char* kind,
                                int version, int oldest = 1);

}  // namespace plumb
