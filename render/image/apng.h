#pragma once

#include <span>
#include <string>
#include <vector>

namespace plumb {

/// Joins PNG files of one size and kind into one animated PNG, which loops without end and whose first frame
/// is what programs show that know no animation. The compressed pictures are kept as they are. `frame_rate`
/// is in frames a second, > 0, kept to a thousandth of a second a frame unless it is a whole number. Throws
/// OutputError when there is no frame, the headers differ, or the rate cannot be written; InputError when a
/// frame is not a PNG.
std::string join_apng(std::span<const std::string> frames, double frame_rate);

/// The frames of an animated PNG of that kind, each as a PNG file; of one that is not animated, itself.
/// Throws InputError that names `name` on bad data, for no frames, or for one that is but a part of the
/// picture.
std::vector<std::string> split_apng(const std::string& bytes, const std::string& name);

}  // namespace plumb
