#include "engine/case/name_rule.h"

#include <algorithm>

namespace plumb {

bool follows_name_rule(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= 100 && name[0] != '-' &&
         std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace plumb
