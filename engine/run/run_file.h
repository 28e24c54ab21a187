#pragma once

#include <string>

#include "engine/run/run.h"

namespace plumb {

/// Version of the layout of run files; a reader refuses a later one. 2: external runs.
inline constexpr long run_file_version = 2;

/// The bytes of a run file (HDF5). Each data set has a `unit`; output/README.md describes the layout.
std::string encode_run(const Run& run);

/// Reads a run file, checks it and reads its case again, for these uses, from the texts it holds.
/// Throws InputError for a file that is missing, cut short, of another format or inconsistent.
Run read_run(const std::string& path, const SectionUse& uses = use_all);

}  // namespace plumb
