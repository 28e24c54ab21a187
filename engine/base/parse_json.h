#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace plumb {

/// Levels of lists and objects within each other, and values in all, of the JSON that is read.
inline constexpr int most_json_depth = 64;
inline constexpr long most_json_values = 16'000'000;

/// Reads a text of JSON, for nlohmann::json and nlohmann::ordered_json. Throws InputError with `name`, line
/// and column for what is not JSON, and with `name` for more levels or values than are read or a number that
/// cannot be stored; and Interrupted. Nothing of the text is in the message.
template <class Json>
Json parse_json(const std::string& text, const std::string& name);

/// What is wrong with a text of JSON that lacks what is looked for in it, in words: "the key 'title' is
/// missing", "a value has another type than it must have".
std::string json_fault(const nlohmann::json::exception& error);

/// Within a handler of what was thrown while a file was read: throws InputError and Interrupted on, and turns
/// all else into the InputError "FILE: cannot be used: WHY".
[[noreturn]] void refuse_unusable(const std::string& file);

}  // namespace plumb
