#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/hdf5.h"
#include "engine/integrate/trajectory.h"
#include "engine/run/provenance.h"

/// What run files and study files have in common.
namespace plumb {

/// Each counter with the name it is stored by: "steps", "rejected_steps", ….
std::span<const std::pair<const char*, long Counters::*>> stored_counters();

/// Each kind of energy in the same way: "kinetic", "axial", "bending", "potential".
std::span<const std::pair<const char*, double Energies::*>> stored_energies();
/// False of those that runs of older versions do not have, and which were 0 then.
bool is_stored_always(double Energies::*part);

template <class Archive>
void members(Archive& a, Counters& counters) {
  for (const auto& [name, part] : stored_counters()) a(name, counters.*part);
}

template <class Archive>
void members(Archive& a, PathPoint& point) {
  a("load", point.load);
  a("displacement", point.displacement);
  a("negative_eigenvalues", point.negative);
  a("joined", point.joined);
}

template <class Archive>
void members(Archive& a, CriticalPoint& point) {
  a("kind", point.kind);
  a("load", point.load);
  a("displacement", point.displacement);
  a("negative_before", point.negative_before);
  a("negative_after", point.negative_after);
  a("at", point.at);
  a("direction", point.direction);
  a("what_followed", point.what_followed);
}

template <class Archive>
void members(Archive& a, Equilibria& equilibria) {
  a("negative_eigenvalues", equilibria.negative_eigenvalues);
  a("critical_points", equilibria.critical_points);
  a("path", equilibria.path);
}

/// The name and version of a file's layout: "plumb-run", 1. `read_format` throws std::runtime_error for
/// another `kind` of file ("run file") and for a version beyond what this program reads.
void write_format(std::string_view name, long version, hdf5::Writer& file);
void read_format(const hdf5::Reader& file, std::string_view name, long version, std::string_view kind);

void write_provenance(const Provenance& provenance, hdf5::Writer& file);
Provenance read_provenance(const hdf5::Reader& file);

}  // namespace plumb
