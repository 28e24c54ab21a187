#include "engine/run/rounding_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/integrate/integrate.h"
#include "engine/run/probes.h"

namespace plumb {

ProbeTable rounding_reach(const Case& spec, const ProbeTable& probes) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  Case neighbour = spec;
  neighbour.cable.length *= 1 + rounding;
  const ProbeTable other = probe(neighbour, integrate(neighbour));
  ProbeTable reach = probes;
  for (std::size_t c = 0; c < reach.columns.size(); ++c) {
    double greatest = 0;
    std::vector<double>& values = reach.columns[c].values;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool known =
          c < other.columns.size() && k < other.times.size() && other.times[k] == probes.times[k];
      greatest = known ? std::max(greatest, roundings * std::abs(other.columns[c].values[k] - values[k]))
                       : std::numeric_limits<double>::infinity();
      values[k] = greatest;
    }
  }
  return reach;
}

}  // namespace plumb
