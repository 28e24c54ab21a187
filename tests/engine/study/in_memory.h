#pragma once

#include "engine/study/runner.h"

namespace plumb {

/// A runner whose journal is kept in memory only, for one study: run_sweep(loaded, InMemory()).
struct InMemory {
  Journal journal;
  Runner runner{journal};
  operator Runner&() { return runner; }
};

}  // namespace plumb
