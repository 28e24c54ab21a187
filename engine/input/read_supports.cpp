#include "engine/input/case_sections.h"

namespace plumb {

SupportsSpec read_supports(TableReader table, CableModel model) {
  SupportsSpec supports;
  supports.first = table.choice<Support>("first", supports.first);
  supports.last = table.choice<Support>("last", supports.last);
  table.finish();
  const auto check = [&](const char* end, Support support) {
    if (model == CableModel::chain && support == Support::clamped)
      table.refuse_value(end, "a chain does not bend, so that its ends can be free or pinned only");
  };
  check("first", supports.first);
  check("last", supports.last);
  return supports;
}

}  // namespace plumb
