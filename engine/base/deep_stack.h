#pragma once

#include <cstddef>
#include <functional>

namespace plumb {

/// Does the work with at least that many bytes of stack, in a thread of its own where a usual stack may be
/// too short, and returns when it is done. What the work throws is thrown. Throws InputError where there is
/// no memory or thread to be had for it.
void on_deep_stack(std::size_t bytes, const std::function<void()>& work);

}  // namespace plumb
