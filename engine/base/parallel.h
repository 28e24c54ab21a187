#pragma once

#include <cstddef>
#include <functional>

namespace plumb {

/// Calls `work` once for each index below `count`, on as many threads as there are processors, or as can be
/// had; lower indices begin first. The first exception of a call ends the rest and is thrown again, and so is
/// Interrupted if the user stops it.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace plumb
