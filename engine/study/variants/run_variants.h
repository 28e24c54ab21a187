#pragma once

#include "engine/case/case_source.h"
#include "engine/study/runner.h"
#include "engine/study/variants/variants.h"

namespace plumb {

/// A case with its variants as they went.
struct VariantsStudy {
  LoadedCase loaded;
  Variants result;
};

/// Integrates every variant of a case, in parallel over the processors, and finds its figures. A run that
/// fails is a result. Throws Interrupted if the user stops it.
VariantsStudy run_variants(const LoadedCase& loaded, Runner& runner);

}  // namespace plumb
