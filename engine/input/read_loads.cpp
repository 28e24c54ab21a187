#include "engine/input/case_sections.h"

namespace plumb {

LoadsSpec read_loads(TableReader table) {
  LoadsSpec loads;
  loads.gravity = table.vector("gravity", "m/s²", loads.gravity);
  table.finish();
  return loads;
}

}  // namespace plumb
