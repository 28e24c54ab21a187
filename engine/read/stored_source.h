#pragma once

#include "engine/base/hdf5.h"
#include "engine/case/case_source.h"

namespace plumb {

/// The texts of a case in run files and study files: `case/…`.
void write_source(const CaseSource& source, hdf5::Writer& file);
/// Throws std::runtime_error where they do not fit together.
CaseSource read_source(const hdf5::Reader& file);

}  // namespace plumb
