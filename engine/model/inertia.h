#pragma once

#include <optional>

#include "engine/model/block_tridiagonal.h"

namespace plumb {

/// How many eigenvalues of a symmetric matrix are negative, by Sylvester's law of inertia from the blocks
/// that elimination leaves on the diagonal. Nothing where one of these is singular or not finite, so that it
/// cannot be told.
std::optional<int> negative_eigenvalues(const BlockTridiagonal& A);

}  // namespace plumb
