#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plumb {

/// What a run costs and how far it is off; the less of both the better.
struct WorkError {
  double work = -1;
  double error = -1;  ///< m
};

/// The places of the runs that no other beats: none has both less or equal cost and less or equal error, and
/// one of them less. Of equals the first counts. In the order of rising cost, and so of falling error. Runs
/// with a negative or no number are left out.
std::vector<std::size_t> pareto_front(std::span<const WorkError> runs);

}  // namespace plumb
