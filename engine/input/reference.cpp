#include "engine/input/reference.h"

#include <algorithm>

namespace plumb {

const ReferenceSeries* Reference::find(std::string_view name) const {
  const auto found = std::find_if(series.begin(), series.end(),
                                  [&](const ReferenceSeries& item) { return item.name == name; });
  return found != series.end() ? &*found : nullptr;
}

}  // namespace plumb
