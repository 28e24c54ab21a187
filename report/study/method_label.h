#pragma once

#include <string>

namespace plumb {

/// The label of a method's curve or map within a sentence: "hht (α = -0.3)" of "hht, α = -0.3, fixed step".
/// How its steps are chosen is left out, as a step or a tolerance beside it says that.
inline std::string label_in_sentence(std::string label) {
  for (const std::string& kind : {std::string(", fixed step"), std::string(", controlled step")})
    if (label.ends_with(kind)) label.resize(label.size() - kind.size());
  const std::size_t comma = label.find(", ");
  return comma == label.npos ? label : label.replace(comma, 2, " (") + ")";
}

}  // namespace plumb
