#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "engine/case/case_source.h"
#include "engine/study/economy/economy.h"

namespace plumb {

/// Version of choice.json; a choice of another version is not used.
inline constexpr int choice_version = 1;

/// A whole search, as journals, choice.json, study.json and results.json have it. What is not finite is null.
nlohmann::ordered_json to_stored(const Economy& economy);
/// Throws nlohmann::json::exception or std::runtime_error for anything else.
void from_stored(const nlohmann::ordered_json& json, Economy& economy);

/// What a choice must have been made of to count: a hash of the case's text and overrides and of the
/// program's revision, 16 hexadecimal digits.
std::string choice_key(const CaseSource& source);

/// choice.json: the search, its key, and `made`, the case that came of it.
std::string encode_choice(const Economy& economy, const std::string& key, const CaseSource& made);
/// Reads it back; nothing where its key is another, or it is none that this program writes.
std::optional<Economy> decode_choice(const std::string& text, const std::string& key);
/// The same for the case that came of it; nothing where it is another.
std::optional<Economy> decode_choice_made(const std::string& text, const CaseSource& made);

}  // namespace plumb
