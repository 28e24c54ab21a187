#include "report/verdict/verdict_uncertainty.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {

void add_uncertainty(std::vector<Verdict>& verdicts, const std::vector<SeriesError>& errors, const Case& spec,
                     const Uncertainty& uncertainty) {
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    const SeriesError& error = errors[k];
    const auto series =
        std::find_if(uncertainty.series.begin(), uncertainty.series.end(), [&](const SeriesUncertainty& any) {
          return any.reference == spec.references[error.reference].name && any.column == error.column;
        });
    if (error.given_run || series == uncertainty.series.end() || verdicts[k].status == VerdictStatus::not_run)
      continue;
    const std::string text = fmt::format(
        "; E = {:+.3g} {} with u_val {}{:.2g} {}: {}", series->error[series->greatest], series->unit,
        series->whole() ? "" : "≥ ", series->validation[series->greatest], series->unit, series->finding);
    verdicts[k].detail += text;
    verdicts[k].message += text;
  }
}

}  // namespace plumb
