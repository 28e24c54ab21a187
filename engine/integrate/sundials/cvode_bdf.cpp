#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>

#include "engine/integrate/sundials/cvode_method.h"
#include "engine/integrate/sundials/reduced_linear_solver.h"

namespace plumb {
namespace {

/// CVODE's backward differentiation formulas of variable order and step (Hindmarsh et al. 2005), with
/// Newton's iteration on the block banded matrix M + γ² K.
class CvodeBdf : public sundials::CvodeMethod {
 public:
  CvodeBdf(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : CvodeMethod(CV_BDF, spec, dynamics, start),
        system_(dynamics),
        matrix_(sundials::make_matrix(context())),
        solver_(sundials::make_solver(system_, context())) {
    CVodeSetLinearSolver(cvode(), solver_.get(), matrix_.get());
    CVodeSetLinSysFn(cvode(), linear_system);
  }

 private:
  void count_iterations() override {
    CVodeGetNumNonlinSolvIters(cvode(), &dynamics().counters.newton_iterations);
  }

  static int linear_system(double t, N_Vector y, N_Vector, SUNMatrix, int, int* fresh, double gamma,
                           void* user_data, N_Vector, N_Vector, N_Vector) {
    // A new tangent costs no more than keeping the old one would.
    *fresh = SUNTRUE;
    auto& self = static_cast<CvodeBdf&>(*static_cast<LibraryMethod*>(user_data));
    return self.system_.prepare(t, y, gamma);
  }

  sundials::ReducedSystem system_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
};

}  // namespace

MethodEntry cvode_bdf_entry() {
  MethodInfo info;
  info.name = "cvode-bdf";
  info.summary = "SUNDIALS CVODE: backward differentiation with controlled order and step";
  info.source = "Hindmarsh et al. 2005";
  info.order = "1 to 5";
  info.conserves = "momentum";
  info.use = "stiff or fine cables whose fast axial motion may be damped";
  info.family = MethodFamily::multistep;
  info.implicit = true;
  info.takes_tolerances = true;
  info.varied = {"max_order", "order ≤ {:g}", {2, 5}};
  info.cost = {3300, 3000};
  info.parameters = {{.name = "max_order",
                      .meaning = "highest order used; 2 and below are stable at every oscillation",
                      .minimum = 1,
                      .maximum = 5,
                      .fallback = 5,
                      .whole = true}};
  return {info, made<CvodeBdf>};
}

}  // namespace plumb
