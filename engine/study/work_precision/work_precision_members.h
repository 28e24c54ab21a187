#pragma once

#include "engine/base/codec.h"
#include "engine/run/method_json.h"
#include "engine/run/stored_parts.h"
#include "engine/study/reference/certified_reference.h"
#include "engine/study/work_precision/work_precision.h"

/// What the journal, and of curves of other programs the study file, keeps of a work-precision study.
namespace plumb {

template <class Archive>
void members(Archive& a, ErrorNorms& norms) {
  a("tip_max", norms.tip_max);
  a("tip_rms", norms.tip_rms);
  a("curve", norms.curve);
  a("energy", norms.energy);
}

template <class Archive>
void members(Archive& a, WorkPrecisionRun& run) {
  a("method", run.method);
  a("elements", run.elements);
  a("outcome", run.outcome);
  a("message", run.message);
  a("counters", run.counters);
  a("seconds", run.seconds);
  a("foreseen_seconds", run.foreseen_seconds);
  a("time_error", run.time_error);
  a("total_error", run.total_error);
}

template <class Archive>
void members(Archive& a, GivenPoint& point) {
  a("label", point.label);
  a("file", point.file);
  a("seconds", point.seconds);
  a("why_not", point.why_not);
  a("time_error", point.time_error);
  a("total_error", point.total_error);
}

template <class Archive>
void members(Archive& a, GivenCurve& curve) {
  a("name", curve.name);
  a("program", curve.program);
  a("threads", curve.threads);
  a("machine", curve.machine);
  a("yardstick", curve.yardstick);
  a("points", curve.points);
}

/// Without its trajectory, and as nothing has been held against it yet. Without a method where none
/// completed it.
template <class Archive>
void members(Archive& a, StudyReference& reference) {
  a("method", reference.method);
  a("elements", reference.certificate.elements);
  a("first", reference.certificate.first);
  a("second", reference.certificate.second);
  a("agreement", reference.certificate.agreement);
}

}  // namespace plumb
