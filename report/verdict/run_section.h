#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/base/document_value.h"
#include "report/verdict/verdict.h"

namespace plumb {

struct Figure;

/// What was computed beside a run and is added to its report. A PageSection of the same key shows it.
struct RunSection {
  std::string key = {};  ///< in results.json: "work_precision"; empty: it has verdicts alone
  Document json = {};    ///< what stands there
  /// The key in results.json of what `figures` gives; "figures": they are among those of the run.
  std::string figures_key = {};
  std::string drawing_stage = {};                     ///< in which they are drawn; empty: in none of its own
  std::function<std::vector<Figure>()> figures = {};  ///< may be empty
  /// Adds to verdicts, of which the first are those of `errors`; may be empty.
  std::function<void(std::vector<Verdict>& verdicts, const std::vector<SeriesError>& errors)> judge = {};
  std::string sentence = {};  ///< what the headline says of it at its end; may be empty
};

}  // namespace plumb
