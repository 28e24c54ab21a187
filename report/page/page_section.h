#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/document/document.h"

namespace plumb {

/// A script, with its SHA-256 in hexadecimal.
struct PageScript {
  std::string_view text, sha256;
};

/// Where a section stands in the page of a run.
enum class PagePlace {
  comparisons,  ///< after the errors
  cost,         ///< after energy and cost
};

/// How the page of a run shows what its document has under a key. All functions take what stands there, and
/// throw nlohmann's exceptions where that is not as output/README.md says.
struct PageSection {
  std::string key;  ///< in results.json: "error_budget"
  PagePlace place = PagePlace::comparisons;
  std::string id;     ///< of the section: "budget"
  std::string link;   ///< to it, in the navigation
  std::string title;  ///< above it
  std::string (*html)(const Document& json, const std::vector<Picture>& pictures) = nullptr;
  std::string figures_key = {};  ///< of the pictures that it shows; may be empty
  std::string_view css = {};
  PageScript script = {};
  std::string data_id = {};                             ///< of the data that its script works with
  std::string (*data)(const Document& json) = nullptr;  ///< these, as JSON; nullptr: no script
  /// What it adds to the conclusion of the page, from the whole document; nullptr: nothing.
  std::string (*clause)(const Document& document) = nullptr;
  std::string (*line)(const Document& json) =
      nullptr;  ///< what is said of it on a terminal; nullptr: nothing
};

}  // namespace plumb
