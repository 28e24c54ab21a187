#include "engine/base/place.h"

#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/base/message.h"

namespace plumb {

std::string to_string(const Place& place) {
  return place.in_override() ? place.name : fmt::format("{}:{}:{}", place.name, place.line, place.column);
}

void refuse(const Place& place, std::string_view key, std::string_view value, std::string_view what,
            std::string_view computed) {
  std::string message = to_string(place);
  const bool shown = place.in_override() && place.name.starts_with(fmt::format("--set {}=", key));
  if (!shown && !key.empty()) message += fmt::format(": {}", key);
  if (!shown && !value.empty()) message += fmt::format(" = {}", value);
  if (!computed.empty()) message += fmt::format(" (= {})", computed);
  message += fmt::format(": {}", what);
  throw InputError(one_line(message));
}

}  // namespace plumb
