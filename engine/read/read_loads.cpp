#include "engine/read/case_sections.h"

namespace plumb {

LoadsSpec read_loads(TableReader table) {
  LoadsSpec loads;
  loads.gravity = table.vector("gravity", "m/s²", loads.gravity);
  loads.end_force = table.vector("end_force", "N", loads.end_force);
  table.finish();
  return loads;
}

}  // namespace plumb
