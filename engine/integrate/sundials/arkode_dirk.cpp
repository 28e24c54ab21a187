#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_ls.h>

#include <new>

#include "engine/integrate/newton_leftover.h"
#include "engine/integrate/sundials/arkode_method.h"
#include "engine/integrate/sundials/arkode_tables.h"
#include "engine/integrate/sundials/reduced_linear_solver.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

struct FreeArk {
  void operator()(void* memory) const { ARKStepFree(&memory); }
};

/// ARKODE's diagonally implicit Runge-Kutta methods (Reynolds et al. 2023), all with an explicit first stage,
/// stiffly accurate and L-stable: of order 2 TR-BDF2 (Bank et al. 1985; Hosea and Shampine 1996), of order 3
/// and 4 those of Kennedy and Carpenter 2016, of order 5 that of 2019. Each stage is solved by Newton's
/// iteration on the block banded matrix M + γ² K.
class ArkodeDirk : public sundials::ArkodeMethod {
 public:
  ArkodeDirk(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : ArkodeMethod(spec, dynamics, start),
        system_(dynamics),
        matrix_(sundials::make_matrix(context())),
        solver_(sundials::make_solver(system_, context())),
        ark_(ARKStepCreate(nullptr, right_hand_side, start.t, y(), context())) {
    if (!ark_) throw std::bad_alloc();
    void* ark = ark_.get();
    ARKStepSetUserData(ark, static_cast<LibraryMethod*>(this));
    ARKStepSetErrHandlerFn(ark, sundials::keep_message, &message());
    const int order = static_cast<int>(spec.parameters.at("order"));
    ARKStepSetTableNum(ark, implicit_table_of(order), ARKODE_ERK_NONE);
    ARKStepSetLinearSolver(ark, solver_.get(), matrix_.get());
    ARKStepSetLinSysFn(ark, linear_system);
    // A tangent costs less than the iterations that an old one adds, and a matrix for another γ, with its
    // solution scaled for that, spoils the first correction.
    ARKStepSetLSetupFrequency(ark, 1);
    ARKStepSetJacEvalFrequency(ark, 1);
    ARKStepSetLinearSolutionScaling(ark, SUNFALSE);
    ARKStepSetNonlinConvCoef(ark, iteration_share);
    // A stage's rate follows from its converged equation, without another evaluation.
    ARKStepSetDeduceImplicitRhs(ark, SUNTRUE);
    ARKStepSetMaxNonlinIters(ark, static_cast<int>(spec.parameters.at("newton_iterations")));
    if (has_fixed_step()) {
      tolerate(leftover_of_a_step(spec, dynamics, weight_of_leftover), *spec.step);
    } else {
      ARKStepSVtolerances(ark, *spec.rtol, absolute_tolerances(*spec.atol).get());
      ARKStepSetPredictorMethod(ark, maximum_order);
    }
  }

  long rejected_steps() const override {
    long error_failures = 0, convergence_failures = 0;
    ARKStepGetNumErrTestFails(ark_.get(), &error_failures);
    ARKStepGetNumNonlinSolvConvFails(ark_.get(), &convergence_failures);
    return error_failures + convergence_failures;
  }

 private:
  /// The library's number for extrapolating the last step with the highest order at hand.
  static constexpr int maximum_order = 1;
  /// What Newton's iteration may leave, as a fraction of the tolerance. It enters the estimated error as it
  /// is, however short the step: with a tenth, the library's own choice, it can exceed the tolerance at every
  /// step.
  static constexpr double iteration_share = 0.01;
  /// The library asks for the root mean square of what is left, in each of several stages.
  static constexpr double weight_of_leftover = 10;

  /// Ends Newton's iteration where the corrections are below a length (m): slopes count by the length of an
  /// element, rates by the step h (s).
  void tolerate(double length, double h) {
    const Eigen::Index n = dynamics().size();
    const sundials::Vector allowed = sundials::make_vector(2 * n, context());
    auto q = sundials::q_of(allowed.get(), n);
    for (Eigen::Index node = 0; node < n / 6; ++node) {
      q.segment<3>(6 * node).setConstant(length);
      q.segment<3>(6 * node + 3).setConstant(length / dynamics().cable().element().length());
    }
    sundials::v_of(allowed.get(), n) = q / h;
    ARKStepSVtolerances(ark_.get(), 0, allowed.get());
  }

  void fix_step(double h) override { ARKStepSetFixedStep(ark_.get(), h); }
  void stop_at(double stop) override { ARKStepSetStopTime(ark_.get(), stop); }
  int take_step(double stop, double& reached) override {
    const int flag = ARKStepEvolve(ark_.get(), stop, y(), &reached, ARK_ONE_STEP);
    ARKStepGetNumNonlinSolvIters(ark_.get(), &dynamics().counters.newton_iterations);
    return flag;
  }
  void dense_output(double t, N_Vector to) const override { ARKStepGetDky(ark_.get(), t, 0, to); }

  static int linear_system(double t, N_Vector y, N_Vector, SUNMatrix, SUNMatrix, int, int* fresh,
                           double gamma, void* user_data, N_Vector, N_Vector, N_Vector) {
    // A new tangent costs no more than keeping the old one would.
    *fresh = SUNTRUE;
    auto& self = static_cast<ArkodeDirk&>(*static_cast<LibraryMethod*>(user_data));
    return self.system_.prepare(t, y, gamma);
  }

  sundials::ReducedSystem system_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
  std::unique_ptr<void, FreeArk> ark_;
};

}  // namespace

MethodEntry arkode_dirk_entry() {
  MethodInfo info;
  info.name = "arkode-dirk";
  info.summary = "SUNDIALS ARKODE: diagonally implicit, L-stable Runge-Kutta pairs";
  info.source = "Reynolds et al. 2023; Kennedy and Carpenter 2016, 2019; Bank et al. 1985 for order 2";
  info.order = "2 to 5";
  info.stage_order = 2;  // the first stage is explicit
  info.conserves = "momentum";
  info.use = "stiff or fine cables at moderate and tight accuracy";
  info.family = MethodFamily::implicit_stages;
  info.implicit = true;
  info.takes_step = true;
  info.takes_tolerances = true;
  info.varied = {"order", "order {:g}", {3, 5}};
  info.cost = {3500, 6000};
  info.amplification = [](const MethodSpec& spec, double z) {
    return amplification(implicit_table(static_cast<int>(spec.parameters.at("order"))), z);
  };
  info.parameters = {
      {.name = "order",
       .meaning = "2 TR-BDF2, 3 to 5 Kennedy and Carpenter's ESDIRK3(2)5, ESDIRK4(3)7 and ESDIRK5(4)7",
       .minimum = 2,
       .maximum = 5,
       .fallback = 5,
       .whole = true},
      {.name = "newton_tolerance",
       .meaning = newton_tolerance_meaning,
       .minimum = 1e-15,
       .maximum = 1e-3,
       .fallback = 1e-9},
      {.name = "newton_iterations",
       .meaning = "most corrections in a stage",
       .minimum = 1,
       .maximum = 100,
       .fallback = 10,
       .whole = true}};
  return {info, made<ArkodeDirk>};
}

}  // namespace plumb
