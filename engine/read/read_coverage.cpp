#include <fmt/format.h>

#include <algorithm>

#include "engine/read/case_sections.h"

namespace plumb {

bool CoverageSpec::has(double t) const {
  constexpr double rounding = 1e-9;
  return !(from && t < *from * (1 - rounding)) && !(to && t > *to * (1 + rounding));
}

CoverageSpec read_coverage(TableReader table, const std::vector<double>& times, const std::string& whose) {
  CoverageSpec coverage;
  coverage.from = table.optional_number("from", Range::at_least(0, "s"));
  coverage.to = table.optional_number("to", Range::positive("s"));
  coverage.share = table.number("share", {.low = 0, .high = 1, .low_open = true, .unit = "of the times"}, 1);
  table.finish();
  if (coverage.from && coverage.to && !(*coverage.to > *coverage.from))
    table.refuse_value("to", fmt::format("must be greater than from, {} (s)", *coverage.from));
  if (!coverage.from && !coverage.to) return coverage;
  if (std::none_of(times.begin(), times.end(), [&](double t) { return t > 0 && coverage.has(t); }))
    table.refuse_value(coverage.to ? "to" : "from",
                       fmt::format("leaves no time of {} after t = 0, which are to {} s", whose,
                                   times.empty() ? 0 : times.back()));
  return coverage;
}

}  // namespace plumb
