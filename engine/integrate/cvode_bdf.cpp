#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>

#include <new>

#include "engine/integrate/reduced_linear_solver.h"

namespace plumb {
namespace {

struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};

/// CVODE's backward differentiation formulas of variable order and step (Hindmarsh et al. 2005), with
/// Newton's iteration on the block banded matrix M + γ² K.
class CvodeBdf : public sundials::LibraryMethod {
 public:
  CvodeBdf(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : LibraryMethod(dynamics, start),
        system_(dynamics),
        matrix_(system_.make_matrix(context())),
        solver_(system_.make_solver(context())),
        cvode_(CVodeCreate(CV_BDF, context())) {
    if (!cvode_) throw std::bad_alloc();
    void* cvode = cvode_.get();
    CVodeInit(cvode, evaluate, start.t, y());
    CVodeSetUserData(cvode, this);
    CVodeSStolerances(cvode, *spec.rtol, *spec.atol);
    CVodeSetLinearSolver(cvode, solver_.get(), matrix_.get());
    CVodeSetLinSysFn(cvode, linear_system);
    CVodeSetErrHandlerFn(cvode, sundials::keep_message, &message());
    CVodeSetMaxOrd(cvode, static_cast<int>(spec.parameters.at("max_order")));
  }

  long rejected_steps() const override {
    long error_failures = 0, convergence_failures = 0;
    CVodeGetNumErrTestFails(cvode_.get(), &error_failures);
    CVodeGetNumNonlinSolvConvFails(cvode_.get(), &convergence_failures);
    return error_failures + convergence_failures;
  }

 private:
  int evolve(double stop, double& reached) override {
    CVodeSetStopTime(cvode_.get(), stop);
    const int flag = CVode(cvode_.get(), stop, y(), &reached, CV_ONE_STEP);
    CVodeGetNumNonlinSolvIters(cvode_.get(), &right_hand_side().dynamics.counters.newton_iterations);
    return flag;
  }

  void dense_output(double t, N_Vector to) const override { CVodeGetDky(cvode_.get(), t, 0, to); }

  static int evaluate(double t, N_Vector y, N_Vector ydot, void* user_data) {
    return sundials::RightHandSide::evaluate(t, y, ydot,
                                             &static_cast<CvodeBdf*>(user_data)->right_hand_side());
  }

  static int linear_system(double, N_Vector y, N_Vector, SUNMatrix, int, int* fresh, double gamma,
                           void* user_data, N_Vector, N_Vector, N_Vector) {
    // A new tangent costs no more than keeping the old one would.
    *fresh = SUNTRUE;
    return static_cast<CvodeBdf*>(user_data)->system_.prepare(y, gamma);
  }

  sundials::ReducedSystem system_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
  std::unique_ptr<void, FreeCvode> cvode_;
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
  info.parameters = {{.name = "max_order",
                      .meaning = "highest order used; 2 and below are stable at every oscillation",
                      .minimum = 1,
                      .maximum = 5,
                      .fallback = 5,
                      .whole = true}};
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<CvodeBdf>(spec, dynamics, start);
          }};
}

}  // namespace plumb
