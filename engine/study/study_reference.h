#pragma once

#include "engine/study/work_precision.h"

namespace plumb {

/// A trajectory that stands for the exact motion of a mesh, and how well two unlike methods agree on it.
struct StudyReference {
  Trajectory trajectory;  ///< without outputs if no method gave one
  MethodSpec method;      ///< that gave it
  CertifiedReference certificate;
};

/// Integrates the cable of a case, on its mesh, by ARKODE's explicit pairs of order 5 and 8 and by the
/// Nyström pair of order 8 with a fixed step, both finer and finer until their tips agree to
/// `target` (m), as long as that helps and takes no more than `time_limit` (s of the processor) in all.
/// `agreement` is the best that was reached.
StudyReference make_reference(const Case& spec, double target, double time_limit);

/// The agreement of two methods on a case, with the first one's trajectory as the reference.
StudyReference hold_together(const Case& spec, const MethodSpec& first, const MethodSpec& second,
                             double time_limit);

/// Judges a reference by the smallest error drawn against it (m; negative: none), with `mesh_error` as its
/// own distance to the continuum (0 where only time integration is in question; negative: not known).
void certify(CertifiedReference& reference, double smallest_error, double mesh_error = 0);

}  // namespace plumb
