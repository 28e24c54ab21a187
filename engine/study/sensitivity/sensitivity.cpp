#include "engine/study/sensitivity/sensitivity.h"

#include <algorithm>

namespace plumb {

long Sensitivity::noticed_numbers(std::size_t criterion) const {
  const auto notices = [&](const SearchedSide& side) {
    const NoticedChange& change = side.noticed[criterion];
    return change.change > 0 && change.change <= 1 && !change.by_failure;
  };
  return std::count_if(numbers.begin(), numbers.end(), [&](const NumberSensitivity& number) {
    return notices(number.up) || notices(number.down);
  });
}

long Sensitivity::noticed_blunders(std::size_t criterion) const {
  return std::count_if(blunders.begin(), blunders.end(), [&](const BlunderSensitivity& any) {
    return any.blunder.kind != Blunder::double_mesh && !any.trial.failed() && any.trial.notices(criterion);
  });
}

bool Sensitivity::told() const {
  return std::any_of(numbers.begin(), numbers.end(),
                     [](const NumberSensitivity& any) { return any.told(); }) ||
         std::any_of(blunders.begin(), blunders.end(),
                     [](const BlunderSensitivity& any) { return any.applies() && !any.trial.untold(); });
}

bool Sensitivity::weak(std::size_t criterion) const {
  return criteria[criterion].met && told() && noticed_numbers(criterion) + noticed_blunders(criterion) == 0;
}

std::vector<std::string> Sensitivity::weak_names() const {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < criteria.size(); ++k)
    if (weak(k)) names.push_back(criteria[k].name);
  return names;
}

}  // namespace plumb
