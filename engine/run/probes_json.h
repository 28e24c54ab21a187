#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/run/probes.h"

/// What journals and study files keep of what a run saw.
namespace plumb {

template <class Archive>
void members(Archive& a, Column& column) {
  a("name", column.name);
  a("unit", column.unit);
  a("values", column.values);
}

template <class Archive>
void members(Archive& a, ProbeTable& table) {
  a("times", table.times);
  a("columns", table.columns);
}

/// A list for each kind of energy, one value an output.
nlohmann::ordered_json to_stored(const std::vector<Energies>& energies);
/// Throws std::runtime_error where the lists have different lengths.
void from_stored(const nlohmann::ordered_json& json, std::vector<Energies>& energies);

}  // namespace plumb
