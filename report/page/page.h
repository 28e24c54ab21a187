#pragma once

#include <string>

#include "report/document/document.h"

namespace plumb {

/// index.html: the report as one file that asks nothing of anywhere and can be read without scripts. All that
/// it says is in the document. Throws nlohmann's exceptions where the document lacks what output/README.md
/// says of it.
std::string to_page(const Document& document, const Pictures& pictures);

}  // namespace plumb
