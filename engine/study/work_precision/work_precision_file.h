#pragma once

#include <string>

#include "engine/case/case_source.h"
#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// A finished work-precision study with the case it is of.
struct Study {
  LoadedCase loaded;
  WorkPrecision result;
};

/// Version of the layout of study files; a reader refuses a later one.
inline constexpr long study_file_version = 1;

/// The bytes of a study file (HDF5). Each data set has a `unit`; output/README.md describes the layout.
std::string encode_study(const Study& study);

/// Reads a study file, checks it, reads its case again from the texts it holds, and judges its runs anew.
/// Throws InputError for a file that is missing, cut short, of another format or inconsistent.
Study read_study(const std::string& path);

}  // namespace plumb
