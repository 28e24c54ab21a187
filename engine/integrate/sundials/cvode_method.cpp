#include "engine/integrate/sundials/cvode_method.h"

#include <cvode/cvode.h>

#include <new>

namespace plumb::sundials {

void FreeCvode::operator()(void* memory) const {
  CVodeFree(&memory);
}

CvodeMethod::CvodeMethod(int family, const MethodSpec& spec, Dynamics& dynamics, const State& start)
    : LibraryMethod(dynamics, start), cvode_(CVodeCreate(family, context())) {
  if (!cvode_) throw std::bad_alloc();
  CVodeInit(cvode(), right_hand_side, start.t, y());
  CVodeSetUserData(cvode(), static_cast<LibraryMethod*>(this));
  const int highest_order = static_cast<int>(spec.parameters.at("max_order"));
  const double share = multistep_share(*spec.rtol, highest_order);
  CVodeSVtolerances(cvode(), share * *spec.rtol, absolute_tolerances(share * *spec.atol).get());
  CVodeSetErrHandlerFn(cvode(), keep_message, &message());
  CVodeSetMaxOrd(cvode(), highest_order);
}

long CvodeMethod::rejected_steps() const {
  long error_failures = 0, convergence_failures = 0;
  CVodeGetNumErrTestFails(cvode(), &error_failures);
  CVodeGetNumNonlinSolvConvFails(cvode(), &convergence_failures);
  return error_failures + convergence_failures;
}

int CvodeMethod::evolve(double stop, double& reached) {
  CVodeSetStopTime(cvode(), stop);
  const int flag = CVode(cvode(), stop, y(), &reached, CV_ONE_STEP);
  count_iterations();
  return flag;
}

void CvodeMethod::dense_output(double t, N_Vector to) const {
  CVodeGetDky(cvode(), t, 0, to);
}

}  // namespace plumb::sundials
