#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// What the page of a run says before anything else.
struct Conclusion {
  bool good = false;     ///< completed, with every criterion met
  std::string sentence;  ///< what was found, with its numbers
  std::string trouble;   ///< how the integration failed; empty where it did not
  std::string help;      ///< what would help; empty where that is not known
};

/// Draws it from the figures of the document, and claims nothing beyond them. `clause` is what the sections
/// of the page add to its sentence.
Conclusion conclusion_of(const Document& document, const std::string& clause = "");

}  // namespace plumb
