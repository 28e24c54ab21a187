#pragma once

#include <vector>

#include "engine/study/uncertainty/uncertainty.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// Adds to the text of each verdict its comparison error E where that is greatest, the validation uncertainty
/// there, and what follows. `verdicts` and `errors` go together; those without an estimate stay as they are.
void add_uncertainty(std::vector<Verdict>& verdicts, const std::vector<SeriesError>& errors, const Case& spec,
                     const Uncertainty& uncertainty);

}  // namespace plumb
