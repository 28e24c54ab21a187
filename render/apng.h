#pragma once

#include <span>
#include <string>

namespace plumb {

/// Joins PNG files of one size and kind into one animated PNG, which loops without end and whose first frame
/// is what programs show that know no animation. The compressed pictures are kept as they are. `frame_rate`
/// is in frames a second, > 0, kept to a thousandth of a second a frame unless it is a whole number. Throws
/// OutputError when there is no frame, the headers differ, or the rate cannot be written; InputError when a
/// frame is not a PNG.
std::string join_apng(std::span<const std::string> frames, double frame_rate);

}  // namespace plumb
