#include "engine/study/uncertainty/uncertainty.h"

#include <algorithm>

namespace plumb {

std::string_view word(PartState state) {
  switch (state) {
    case PartState::not_estimated:
      return "not estimated";
    case PartState::estimated:
      return "estimated";
    case PartState::bounded:
      return "bounded";
    case PartState::no_part:
      return "no part";
  }
  return "not estimated";
}

bool SeriesUncertainty::whole() const {
  return std::none_of(parts.begin(), parts.end(),
                      [](const UncertaintyPart& part) { return part.state == PartState::not_estimated; });
}

}  // namespace plumb
