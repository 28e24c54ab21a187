#pragma once

#include <string>

#include "report/diff/file_difference.h"

namespace plumb {

/// Compares two PNG files as they are seen: the still picture, and of animations every frame on what those
/// before it leave, how long each is shown, and how often all are. Files whose chunks give the same pixels
/// other colours, or turn them, are different. Throws InputError that names `name_a` or `name_b` for what
/// cannot be read, and Interrupted.
FileDifference compare_pictures(const std::string& a, const std::string& name_a, const std::string& b,
                                const std::string& name_b, const DifferenceOptions& options);

}  // namespace plumb
