#include "engine/read/case_sections.h"

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
  if (model == CableModel::rigid) {
    if (supports.first != Support::pinned)
      table.refuse_value("first", "must be \"pinned\" for a rigid rod, which turns on a joint there");
    if (supports.last != Support::free)
      table.refuse_value("last", "must be \"free\" for a rigid rod, which turns about its first end");
  }
  check("first", supports.first);
  check("last", supports.last);
  return supports;
}

}  // namespace plumb
