#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/study/economy/economy_study.h"

namespace plumb {

/// The word for this kind of study.
inline constexpr const char* economy_kind = "economy";

/// A random scene as results.json has it.
nlohmann::ordered_json random_scene_json(const RandomScene& scene);

/// study.json: all of it, with the texts of its case.
std::string encode_economy_study(const EconomyStudy& study);

/// Reads it back and its case again from the texts. Throws InputError, naming `file`, for anything that
/// encode_economy_study does not write.
EconomyStudy decode_economy_study(const std::string& json, const std::string& file);

}  // namespace plumb
