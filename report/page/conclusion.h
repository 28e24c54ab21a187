#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"

namespace plumb {

/// What the page of a run says before anything else.
struct Conclusion {
  bool good = false;     ///< completed, with every criterion met
  std::string sentence;  ///< what was found, with its numbers
  std::string details;   ///< what the sections of the page add to it; may be empty
  std::string trouble;   ///< how the integration failed; empty where it did not
  std::string help;      ///< what would help; empty where that is not known
};

/// Draws it from the figures of the document, and claims nothing beyond them. `clauses` are those of the
/// sections of the page, each a sentence that begins in a small letter and ends without a stop.
Conclusion conclusion_of(const Document& document, const std::vector<std::string>& clauses = {});

}  // namespace plumb
