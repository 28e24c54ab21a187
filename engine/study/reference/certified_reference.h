#pragma once

#include <string>

#include "engine/case/case.h"
#include "engine/integrate/trajectory.h"

namespace plumb {

/// A reference that two unlike methods of high order agree on.
struct CertifiedReference {
  int elements = 0;
  std::string first;           ///< method and settings whose trajectory serves as the reference
  std::string second;          ///< the one it was held against
  double agreement = -1;       ///< greatest distance of their tips, m; -1: one of them failed
  double smallest_error = -1;  ///< the smallest error drawn against it, m; -1: none
  /// True if the two agree to a tenth of the smallest error drawn. Otherwise `floor` is drawn.
  bool certified = false;
  double floor =
      0;  ///< m: errors below it mean nothing. Ten times the agreement, or the mesh error if greater
  std::string why_not = {};  ///< in words, where it is not certified
};

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
