#pragma once

#include <string>

#include "report/pictures.h"
#include "report/results.h"

namespace plumb {

/// index.html: the report as one file that asks nothing of anywhere and needs no scripts.
std::string to_page(const Results& results, const Pictures& pictures);

}  // namespace plumb
