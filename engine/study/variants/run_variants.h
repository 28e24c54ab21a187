#pragma once

#include <functional>
#include <string>

#include "engine/case/case_source.h"
#include "engine/study/variants/variants.h"

namespace plumb {

/// A case with its variants as they went.
struct VariantsStudy {
  LoadedCase loaded;
  Variants result;
};

/// Called when a variant has ended, with its name and the share of all that have, 0 to 1. Never called twice
/// at once, but from any thread.
using VariantsProgress = std::function<void(const std::string& name, double share)>;

/// Integrates every variant of a case, in parallel over the processors, and finds its figures. A run that
/// fails is a result. Throws Interrupted if the user stops it.
VariantsStudy run_variants(const LoadedCase& loaded, const VariantsProgress& progress = {});

}  // namespace plumb
