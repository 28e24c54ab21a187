#include "engine/input/probe_columns.h"

#include <algorithm>

namespace plumb {

std::vector<std::string> all_columns(const std::vector<ProbeSpec>& probes) {
  std::vector<std::string> columns;
  for (const ProbeSpec& probe : probes) {
    for (std::string& column : column_names(probe)) columns.push_back(std::move(column));
  }
  return columns;
}

const ProbeSpec* probe_of(const std::string& column, const std::vector<ProbeSpec>& probes) {
  for (const ProbeSpec& probe : probes) {
    const std::vector<std::string> columns = column_names(probe);
    if (std::find(columns.begin(), columns.end(), column) != columns.end()) return &probe;
  }
  return nullptr;
}

}  // namespace plumb
