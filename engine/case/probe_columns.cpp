#include "engine/case/probe_columns.h"

#include <algorithm>
#include <array>

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

std::span<const ModeColumn> mode_columns() {
  static constexpr std::array<ModeColumn, 4> all{
      {{"frequency", "Hz"}, {"angular_frequency", "rad/s"}, {"damping_ratio", "1"}, {"decay", "1/s"}}};
  return all;
}

ProbeColumns::ProbeColumns(const std::vector<ProbeSpec>& probes, bool of_modes) {
  if (of_modes)
    for (const ModeColumn& column : mode_columns()) {
      names_.emplace_back(column.name);
      units_.emplace(column.name, column.unit);
    }
  for (const ProbeSpec& probe : probes)
    for (std::string& column : column_names(probe)) {
      units_.emplace(column, plumb::unit(probe.quantity));
      names_.push_back(std::move(column));
    }
}

std::optional<std::string_view> ProbeColumns::unit(const std::string& column) const {
  const auto found = units_.find(column);
  return found == units_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace plumb
