#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// The numbers of a case that an [[uncertainty.input]] may be of, by the key that --set takes:
/// "parameters.f", "cable.density", "loads.gravity.1". What is counted or chosen is none of them.
std::vector<std::string> uncertain_keys(const Case& spec);

/// The value that a case has there, in SI units; nothing for a key that is none of them.
std::optional<double> uncertain_value(const Case& spec, std::string_view key);

/// The overrides that give a case other values there: one a key, after those that spell out the lists whose
/// entries are meant, which the file may leave to their defaults. `keys` and `values` go together.
std::vector<std::string> uncertain_overrides(const Case& spec, const std::vector<std::string>& keys,
                                             const std::vector<double>& values);

/// "uniform", "normal".
std::string_view word(Distribution);

}  // namespace plumb
