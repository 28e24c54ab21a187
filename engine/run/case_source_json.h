#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case_source.h"

namespace plumb {

/// The texts of a case as a study.json keeps them: `file`, `overrides`, `references`, and where there are any
/// `runs`, whose files may be binary: each byte is one character, U+0000 to U+00FF.
nlohmann::ordered_json case_source_to_json(const CaseSource& source);

/// Reads them back; earlier files of sweeps and of economy have `name` and `text` in the place of `file`, and
/// no file needs `runs`. Throws nlohmann's exceptions, or std::runtime_error for a character that is no byte.
CaseSource case_source_from_json(const nlohmann::ordered_json& json);

}  // namespace plumb
