#pragma once

#include "engine/base/codec.h"
#include "engine/study/sweep/sweep.h"

/// What the journal, study.json and results.json keep of a sweep.
namespace plumb {

template <class Archive>
void members(Archive& a, SweepRun& run) {
  a("number", run.number);
  a("overrides", run.overrides);
  a("method", run.method);
  a("outcome", run.outcome);
  a("message", run.message);
  a("error", run.error);
  a("second_error", run.second_error);
  a("disagreement", run.disagreement);
  a("judged_until", run.judged_until);
  a("seconds", run.seconds);
  a("finite", run.finite);
  a("fault", run.fault);
}

template <class Archive>
void members(Archive& a, SweepSpec& spec) {
  a("cases", spec.cases);
  a("seed", spec.seed);
  a("tolerance", spec.tolerance);
  a("time_limit", spec.time_limit);
}

}  // namespace plumb
