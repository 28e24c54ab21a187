#include "engine/base/parse_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "engine/base/message.h"
#include "engine/base/place.h"

namespace plumb {
namespace {

/// "PATH:4:10", of a byte from 1.
std::string place_of(const std::string& text, std::size_t byte, const std::string& name) {
  const std::size_t before = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const std::size_t line = text.rfind('\n', before == 0 ? 0 : before - 1);
  const std::size_t begin = before == 0 || line == std::string::npos ? 0 : line + 1;
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(begin),
             to = text.begin() + static_cast<std::ptrdiff_t>(before);
  const auto characters =
      std::count_if(from, to, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return fmt::format("{}:{}:{}", name, 1 + std::count(text.begin(), to, '\n'), 1 + characters);
}

}  // namespace

template <class Json>
Json parse_json(const std::string& text, const std::string& name) {
  long values = 0;
  // The parser's own count of levels; what goes through a value later may call itself once a level.
  const auto look = [&](int depth, typename Json::parse_event_t, Json&) {
    stop_if_interrupted();
    if (depth > most_json_depth)
      throw InputError(
          one_line(fmt::format("{}: JSON of more than {} levels is not read", name, most_json_depth)));
    if (++values > most_json_values)
      throw InputError(
          one_line(fmt::format("{}: JSON of more than {} values is not read", name, most_json_values)));
    return true;
  };
  try {
    return Json::parse(text, look);
  } catch (const typename Json::parse_error& error) {
    throw InputError(one_line(place_of(text, error.byte, name) + ": is not JSON"));
  } catch (const typename Json::exception& error) {
    throw InputError(one_line(fmt::format("{}: {}", name, json_fault(error))));
  }
}

template nlohmann::json parse_json(const std::string& text, const std::string& name);
template nlohmann::ordered_json parse_json(const std::string& text, const std::string& name);

std::string json_fault(const nlohmann::json::exception& error) {
  constexpr int key_missing = 403, place_missing = 401, number_too_large = 406;
  const std::string_view what = error.what();
  if (error.id == number_too_large) return "a number is larger than any that can be stored";
  if (error.id == place_missing) return "a list is shorter than it must be";
  if (error.id != key_missing) return "a value has another type than it must have";
  // The key is one that was looked for, in quotes.
  const std::size_t from = what.find('\''), to = what.rfind('\'');
  return from < to ? fmt::format("the key {} is missing", what.substr(from, to + 1 - from))
                   : "a key is missing";
}

void refuse_unusable(const std::string& file) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(one_line(fmt::format("{}: cannot be used: {}", file, why)));
  };
  try {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const nlohmann::json::exception& error) {
    refuse(json_fault(error));
  } catch (const std::bad_alloc&) {
    refuse("it is too large for the memory at hand");
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  } catch (const std::exception&) {
    refuse("its values do not fit together");
  }
  throw std::logic_error("no file is read");
}

}  // namespace plumb
