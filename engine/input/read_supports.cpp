#include "engine/input/case_sections.h"

namespace plumb {

SupportsSpec read_supports(TableReader table) {
  SupportsSpec supports;
  supports.first = table.choice<Support>("first", supports.first);
  supports.last = table.choice<Support>("last", supports.last);
  table.finish();
  return supports;
}

}  // namespace plumb
