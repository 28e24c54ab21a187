#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/study/sweep/sweep.h"

namespace plumb {

/// Version of the sweep in study.json; a reader refuses a later one.
inline constexpr int sweep_version = 1;

/// A run as study.json and results.json have it. What is not finite is null.
nlohmann::ordered_json sweep_run_json(const SweepRun& run);

/// study.json of a sweep: all of it, with the texts of its case.
std::string encode_sweep(const Sweep& sweep);

/// Reads it back and its case again from the texts. Throws InputError, naming `file`, for anything that
/// encode_sweep does not write.
Sweep decode_sweep(const std::string& json, const std::string& file);

/// One run of a text that sweep_run_json made. Throws nlohmann::json::exception or std::runtime_error.
SweepRun sweep_run_of(const nlohmann::ordered_json& json);

}  // namespace plumb
