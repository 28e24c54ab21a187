#pragma once

#include <span>
#include <string>
#include <utility>

#include "engine/input/case_source.h"
#include "engine/integrate/trajectory.h"
#include "engine/output/hdf5.h"
#include "engine/output/provenance.h"

/// What run files and study files have in common.
namespace plumb {

/// Each counter with the name it is stored by: "steps", "rejected_steps", ….
std::span<const std::pair<const char*, long Counters::*>> stored_counters();

/// The outcome of that word. Throws std::runtime_error for another one.
Outcome stored_outcome(const std::string& name);

void write_source(const CaseSource& source, hdf5::Writer& file);
CaseSource read_source(const hdf5::Reader& file);

void write_provenance(const Provenance& provenance, hdf5::Writer& file);
Provenance read_provenance(const hdf5::Reader& file);

}  // namespace plumb
