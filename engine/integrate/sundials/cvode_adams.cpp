#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <new>

#include "engine/integrate/sundials/cvode_method.h"

namespace plumb {
namespace {

struct FreeNonlinearSolver {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

/// CVODE's Adams-Moulton formulas of variable order and step (Hindmarsh et al. 2005; Byrne and Hindmarsh
/// 1975), corrected by functional iteration: no matrix, and a step that the highest frequency limits.
class CvodeAdams : public sundials::CvodeMethod {
 public:
  CvodeAdams(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : CvodeMethod(CV_ADAMS, spec, dynamics, start), solver_(SUNNonlinSol_FixedPoint(y(), 0, context())) {
    if (!solver_) throw std::bad_alloc();
    CVodeSetNonlinearSolver(cvode(), solver_.get());
  }

 private:
  std::unique_ptr<_generic_SUNNonlinearSolver, FreeNonlinearSolver> solver_;
};

}  // namespace

MethodEntry cvode_adams_entry() {
  MethodInfo info;
  info.name = "cvode-adams";
  info.summary = "SUNDIALS CVODE: Adams-Moulton formulas with controlled order and step, without a matrix";
  info.source = "Hindmarsh et al. 2005; Byrne and Hindmarsh 1975";
  info.order = "1 to 12";
  info.conserves = "momentum";
  info.use = "soft, coarse cables at tight tolerances: few force evaluations a step";
  info.family = MethodFamily::multistep;
  info.takes_tolerances = true;
  info.cost = {2200, 300};
  info.parameters = {{.name = "max_order",
                      .meaning = "highest order used",
                      .minimum = 1,
                      .maximum = 12,
                      .fallback = 12,
                      .whole = true}};
  return {info, made<CvodeAdams>};
}

}  // namespace plumb
