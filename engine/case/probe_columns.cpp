#include "engine/case/probe_columns.h"

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

ProbeColumns::ProbeColumns(const std::vector<ProbeSpec>& probes) {
  for (const ProbeSpec& probe : probes)
    for (std::string& column : column_names(probe)) {
      probes_.emplace(column, &probe);
      names_.push_back(std::move(column));
    }
}

const ProbeSpec* ProbeColumns::probe(const std::string& column) const {
  const auto found = probes_.find(column);
  return found == probes_.end() ? nullptr : found->second;
}

}  // namespace plumb
