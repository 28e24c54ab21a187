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
class CvodeBdf : public Method {
 public:
  CvodeBdf(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : rhs_{dynamics, {}, {}},
        system_(dynamics),
        y_(sundials::make_vector(start, context_)),
        matrix_(system_.make_matrix(context_)),
        solver_(system_.make_solver(context_)),
        cvode_(CVodeCreate(CV_BDF, context_)),
        state_(start) {
    if (!cvode_) throw std::bad_alloc();
    void* cvode = cvode_.get();
    CVodeInit(cvode, right_hand_side, start.t, y_.get());
    CVodeSetUserData(cvode, this);
    CVodeSStolerances(cvode, *spec.rtol, *spec.atol);
    CVodeSetLinearSolver(cvode, solver_.get(), matrix_.get());
    CVodeSetLinSysFn(cvode, linear_system);
    CVodeSetErrHandlerFn(cvode, sundials::keep_message, &message_);
    CVodeSetMaxOrd(cvode, static_cast<int>(spec.parameters.at("max_order")));
  }

  StepResult step(double stop) override {
    void* cvode = cvode_.get();
    CVodeSetStopTime(cvode, stop);
    long iterations_before = 0;
    CVodeGetNumNonlinSolvIters(cvode, &iterations_before);
    rhs_.collapsed_element = -1;
    double reached = state_.t;
    const int flag = CVode(cvode, stop, y_.get(), &reached, CV_ONE_STEP);
    if (flag < 0) return sundials::failure("CVode", flag, message_, rhs_);
    long iterations = 0;
    CVodeGetNumNonlinSolvIters(cvode, &iterations);
    rhs_.dynamics.counters.newton_iterations += iterations - iterations_before;
    state_.t = reached;
    state_.q = sundials::q_of(y_.get());
    state_.v = sundials::v_of(y_.get());
    return {};
  }

  const State& state() const override { return state_; }

  void interpolate(double t, State& at) const override {
    sundials::Vector y(N_VClone(y_.get()));
    CVodeGetDky(cvode_.get(), t, 0, y.get());
    at.t = t;
    at.q = sundials::q_of(y.get());
    at.v = sundials::v_of(y.get());
  }

  long rejected_steps() const override {
    long error_failures = 0, convergence_failures = 0;
    CVodeGetNumErrTestFails(cvode_.get(), &error_failures);
    CVodeGetNumNonlinSolvConvFails(cvode_.get(), &convergence_failures);
    return error_failures + convergence_failures;
  }

 private:
  static int right_hand_side(double t, N_Vector y, N_Vector ydot, void* user_data) {
    return sundials::RightHandSide::evaluate(t, y, ydot, &static_cast<CvodeBdf*>(user_data)->rhs_);
  }

  static int linear_system(double, N_Vector y, N_Vector, SUNMatrix, int reuse, int* fresh, double gamma,
                           void* user_data, N_Vector, N_Vector, N_Vector) {
    *fresh = reuse ? SUNFALSE : SUNTRUE;
    return static_cast<CvodeBdf*>(user_data)->system_.prepare(y, gamma, reuse != SUNFALSE);
  }

  sundials::Context context_;
  sundials::RightHandSide rhs_;
  sundials::ReducedSystem system_;
  sundials::Vector y_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
  std::unique_ptr<void, FreeCvode> cvode_;
  State state_;
  std::string message_;
};

}  // namespace

MethodEntry cvode_bdf_entry() {
  MethodInfo info;
  info.name = "cvode-bdf";
  info.summary = "SUNDIALS CVODE: backward differentiation with controlled order and step";
  info.source = "Hindmarsh et al. 2005";
  info.order = "1 to 5";
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
