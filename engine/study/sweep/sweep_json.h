#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/study/sweep/sweep.h"

namespace plumb {

/// A run as results.json has it. What is not finite is null.
nlohmann::ordered_json sweep_run_json(const SweepRun& run);

/// study.json of a sweep: all of it, with the texts of its case.
std::string encode_sweep(const Sweep& sweep);

/// Reads it back and its case again from the texts. Throws InputError, naming `file`, for anything that
/// encode_sweep does not write.
Sweep decode_sweep(const std::string& json, const std::string& file);

}  // namespace plumb
