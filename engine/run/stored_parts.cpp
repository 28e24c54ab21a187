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

constexpr const char* given_names_path = "case/given_names";

std::string given_path(std::size_t k) {
  return fmt::format("case/given_files/{}", k);
}

}  // namespace

std::span<const std::pair<const char*, long Counters::*>> stored_counters() {
  return counter_parts;
}

std::span<const std::pair<const char*, double Energies::*>> stored_energies() {
  static constexpr std::pair<const char*, double Energies::*> all[] = {{"kinetic", &Energies::kinetic},
                                                                       {"axial", &Energies::axial},
                                                                       {"bending", &Energies::bending},
                                                                       {"potential", &Energies::potential}};
  return all;
}

Outcome stored_outcome(const std::string& name) {
  for (const Outcome outcome : outcomes())
    if (word(outcome) == name) return outcome;
  throw std::runtime_error("the outcome '" + name + "' is unknown");
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

void write_source(const CaseSource& source, hdf5::Writer& file) {
  file.text("case/name", source.file.name);
  file.text("case/text", source.file.text);
  file.texts("case/overrides", source.overrides);
  std::vector<std::string> names, texts;
  for (const NamedText& reference : source.references) {
    names.push_back(reference.name);
    texts.push_back(reference.text);
  }
  file.texts("case/reference_names", names);
  file.texts("case/reference_texts", texts);
  if (source.given_runs.empty()) return;
  names.clear();
  for (std::size_t k = 0; k < source.given_runs.size(); ++k) {
    names.push_back(source.given_runs[k].name);
    file.bytes(given_path(k), source.given_runs[k].text);
  }
  file.texts(given_names_path, names);
}

CaseSource read_source(const hdf5::Reader& file) {
  CaseSource source{{file.text("case/name"), file.text("case/text")}, file.texts("case/overrides"), {}, {}};
  const auto names = file.texts("case/reference_names"), texts = file.texts("case/reference_texts");
  if (names.size() != texts.size()) throw std::runtime_error("its references do not have one name each");
  for (std::size_t k = 0; k < names.size(); ++k) source.references.push_back({names[k], texts[k]});
  // Runs of older versions have none.
  if (!file.has(given_names_path)) return source;
  for (const std::string& name : file.texts(given_names_path))
    source.given_runs.push_back({name, file.bytes(given_path(source.given_runs.size()))});
  return source;
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
