#include "engine/study/sensitivity/smallest_change.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace plumb {
namespace {

constexpr double steps_outwards[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 3, 9, 99, 999, 9999, 99999};
constexpr double step_inwards = 10;
/// Below, round-off is seen.
constexpr double smallest = 1e-9;
constexpr double well_known = 1.05;

class Search {
 public:
  explicit Search(double largest) : largest_(largest) {}

  /// The change to be tried next for a criterion; nothing: it is known as well as it can be.
  std::optional<double> next(std::size_t criterion) const {
    const auto noticed = first_noticed(criterion);
    std::optional<double> change;
    if (noticed == told_.end()) {
      const double reached = told_.empty() ? 0 : told_.rbegin()->first;
      if (reached < largest_) change = step_beyond(reached);
    } else if (noticed == told_.begin()) {
      if (noticed->first > smallest) change = noticed->first / step_inwards;
    } else if (const double below = std::prev(noticed)->first; noticed->first > well_known * below) {
      change = std::sqrt(noticed->first * below);
    }
    return change && !untold_.contains(*change) ? change : std::nullopt;
  }

  void take(double change, Trial trial) {
    if (!trial.untold()) {
      told_[change] = std::move(trial);
      return;
    }
    untold_.insert(change);
    if (told_.empty() || change > told_.rbegin()->first) ended_ = std::move(trial.message);
  }

  SearchedSide result(const std::vector<bool>& wanted) const {
    SearchedSide side;
    side.runs = static_cast<int>(told_.size() + untold_.size());
    side.searched = told_.empty() ? 0 : told_.rbegin()->first;
    side.ended = ended_;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      NoticedChange& change = side.noticed.emplace_back();
      if (const auto noticed = first_noticed(k); wanted[k] && noticed != told_.end())
        change = {noticed->first, noticed->second.failed()};
    }
    return side;
  }

 private:
  std::map<double, Trial>::const_iterator first_noticed(std::size_t criterion) const {
    auto at = told_.begin();
    while (at != told_.end() && !at->second.notices(criterion)) ++at;
    return at;
  }

  double step_beyond(double reached) const {
    for (const double step : steps_outwards)
      if (step > reached) return std::min(step, largest_);
    return largest_;
  }

  double largest_;
  std::map<double, Trial> told_;
  std::set<double> untold_;
  std::string ended_;
};

}  // namespace

SearchedSide smallest_changes(const std::vector<bool>& wanted, double largest,
                              const std::function<Trial(double change)>& trial) {
  Search search(largest);
  for (std::size_t k = 0; k < wanted.size(); ++k)
    while (const auto change = wanted[k] ? search.next(k) : std::nullopt)
      search.take(*change, trial(*change));
  return search.result(wanted);
}

}  // namespace plumb
