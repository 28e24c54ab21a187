#pragma once

#include <string>

#include "engine/study/variants/run_variants.h"

namespace plumb {

/// The text of a study.json of the kind "variants"; output/README.md describes it.
std::string encode_variants(const VariantsStudy& study);

/// Reads such a text, checks it, and reads its case again from the texts it holds. Throws InputError for one
/// that is cut short, of another kind or version, or inconsistent.
VariantsStudy decode_variants(const std::string& text);

}  // namespace plumb
