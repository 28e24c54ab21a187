#include "engine/study/work_precision/pareto.h"

#include <algorithm>
#include <cmath>

namespace plumb {

std::vector<std::size_t> pareto_front(std::span<const WorkError> runs) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (runs[k].work >= 0 && runs[k].error >= 0 && std::isfinite(runs[k].work + runs[k].error))
      order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return runs[a].work != runs[b].work ? runs[a].work < runs[b].work : runs[a].error < runs[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t k : order)
    if (front.empty() || runs[k].error < runs[front.back()].error) front.push_back(k);
  return front;
}

}  // namespace plumb
