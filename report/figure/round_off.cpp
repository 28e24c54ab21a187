#include "report/figure/round_off.h"

#include <algorithm>
#include <cmath>

namespace plumb {

void mark_round_off(Panel& panel, double round_off) {
  if (!(round_off > 0) || !std::isfinite(round_off)) return;
  for (const Series& series : panel.series)
    if (std::any_of(series.y.begin(), series.y.end(), [&](double y) { return !(std::abs(y) <= round_off); }))
      return;
  constexpr double seen = 3;  // half the axis, of the band
  panel.y.range = {-seen * round_off, seen * round_off};
  Rule band;
  band.from = -round_off;
  band.to = round_off;
  band.label = "below round-off";
  panel.rules.push_back(std::move(band));
}

}  // namespace plumb
