#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// The columns of all probes, in order.
std::vector<std::string> all_columns(const std::vector<ProbeSpec>& probes);

/// The probe that a column is of, or nullptr.
const ProbeSpec* probe_of(const std::string& column, const std::vector<ProbeSpec>& probes);

/// The columns of all probes with the probe that each is of, for many look-ups. The probes must outlive it.
class ProbeColumns {
 public:
  explicit ProbeColumns(const std::vector<ProbeSpec>& probes);
  /// In order.
  const std::vector<std::string>& names() const { return names_; }
  /// The probe of a column, or nullptr.
  const ProbeSpec* probe(const std::string& column) const;

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, const ProbeSpec*> probes_;
};

}  // namespace plumb
