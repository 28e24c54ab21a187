#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// The columns of all probes, in order.
std::vector<std::string> all_columns(const std::vector<ProbeSpec>& probes);

/// The probe that a column is of, or nullptr.
const ProbeSpec* probe_of(const std::string& column, const std::vector<ProbeSpec>& probes);

/// What modes have beside their probes: a column each.
struct ModeColumn {
  std::string_view name, unit;
};
/// "frequency" (Hz), "angular_frequency" (rad/s), "damping_ratio" (1), "decay" (1/s).
std::span<const ModeColumn> mode_columns();

/// The columns of all probes with the probe that each is of, for many look-ups. The probes must outlive it.
class ProbeColumns {
 public:
  /// `of_modes`: with the mode_columns before them.
  explicit ProbeColumns(const std::vector<ProbeSpec>& probes, bool of_modes = false);
  /// In order.
  const std::vector<std::string>& names() const { return names_; }
  /// The unit of a column, or nothing where there is none of that name.
  std::optional<std::string_view> unit(const std::string& column) const;

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::string_view> units_;
};

}  // namespace plumb
