#include "engine/run/stored_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace plumb {
namespace {

constexpr std::pair<const char*, long Counters::*> counter_parts[] = {
    {"steps", &Counters::steps},
    {"rejected_steps", &Counters::rejected_steps},
    {"force_evaluations", &Counters::force_evaluations},
    {"tangent_evaluations", &Counters::tangent_evaluations},
    {"factorizations", &Counters::factorizations},
    {"newton_iterations", &Counters::newton_iterations}};

}  // namespace

std::span<const std::pair<const char*, long Counters::*>> stored_counters() {
  return counter_parts;
}

bool is_stored_always(double Energies::*part) {
  return part != &Energies::interpolation && part != &Energies::work && part != &Energies::dissipated;
}

std::span<const std::pair<const char*, double Energies::*>> stored_energies() {
  static constexpr std::pair<const char*, double Energies::*> all[] = {
      {"kinetic", &Energies::kinetic},
      {"axial", &Energies::axial},
      {"bending", &Energies::bending},
      {"potential", &Energies::potential},
      {"interpolation", &Energies::interpolation},
      {"work", &Energies::work},
      {"dissipated", &Energies::dissipated}};
  return all;
}

void write_format(std::string_view name, long version, hdf5::Writer& file) {
  file.text("format", name);
  file.integer("format_version", version);
}

void read_format(const hdf5::Reader& file, std::string_view name, long version, std::string_view kind) {
  if (file.text("format") != name) throw std::runtime_error(fmt::format("it is no {} of Plumb", kind));
  if (const long stored = file.integer("format_version"); stored < 1 || stored > version)
    throw std::runtime_error(
        fmt::format("its format version is {}, this program reads up to {}", stored, version));
}

void write_provenance(const Provenance& provenance, hdf5::Writer& file) {
  std::vector<std::string> names, values;
  for (const auto& [name, value] : provenance) {
    names.push_back(name);
    values.push_back(value);
  }
  file.texts("provenance/names", names);
  file.texts("provenance/values", values);
}

Provenance read_provenance(const hdf5::Reader& file) {
  Provenance provenance;
  const auto names = file.texts("provenance/names"), values = file.texts("provenance/values");
  for (std::size_t k = 0; k < std::min(names.size(), values.size()); ++k)
    provenance.emplace_back(names[k], values[k]);
  return provenance;
}

}  // namespace plumb
