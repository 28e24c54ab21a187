#pragma once

#include <string>
#include <vector>

#include "report/figure/pictures.h"
#include "report/study/variants/variants_results.h"

namespace plumb {

/// index.html of a study of variants: one file that opens offline, without scripts.
std::string to_variants_page(const VariantsResults& results, const std::vector<Picture>& pictures);

}  // namespace plumb
