#include "engine/case/probe_table.h"

namespace plumb {

const Column* ProbeTable::find(std::string_view name) const {
  for (const Column& column : columns)
    if (column.name == name) return &column;
  return nullptr;
}

}  // namespace plumb
