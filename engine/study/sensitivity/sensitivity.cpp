#include "engine/study/sensitivity/sensitivity.h"

#include <algorithm>

namespace plumb {

bool Sensitivity::weak(std::size_t criterion) const {
  if (!criteria[criterion].met) return false;
  const auto notices = [&](const SearchedSide& side) {
    const NoticedChange& change = side.noticed[criterion];
    return change.change > 0 && change.change <= 1 && !change.by_failure;
  };
  return std::none_of(
             numbers.begin(), numbers.end(),
             [&](const NumberSensitivity& number) { return notices(number.up) || notices(number.down); }) &&
         std::none_of(blunders.begin(), blunders.end(), [&](const BlunderSensitivity& any) {
           return any.blunder.kind != Blunder::double_mesh && !any.trial.failed() &&
                  any.trial.notices(criterion);
         });
}

std::vector<std::string> Sensitivity::weak_names() const {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < criteria.size(); ++k)
    if (weak(k)) names.push_back(criteria[k].name);
  return names;
}

}  // namespace plumb
