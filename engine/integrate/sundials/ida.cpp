#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <new>

#include "engine/integrate/sundials/ida_linear_system.h"
#include "engine/model/cable.h"

namespace plumb {
namespace {

struct FreeIda {
  void operator()(void* memory) const { IDAFree(&memory); }
};

/// IDA's backward differentiation formulas of variable order and step for differential-algebraic equations
/// (Hindmarsh et al. 2005), on the cable with its supports as constraints in the stabilised form of index 2
/// (Gear, Gupta, Leimkuhler 1985):
///   q' = v + Gᵀ μ,   M v' = f(t, q, v) + Gᵀ λ,   G v = 0,   G q = G q₀,   y = (q, v, λ, μ).
/// λ is the reaction of the joint, μ is 0 up to round-off. Without stabilisation μ and the last equation are
/// left out, and nothing brings back a joint that has drifted; as these constraints are linear, which the
/// formulas keep, all that drifts is round-off.
class Ida : public sundials::LibraryMethod {
 public:
  Ida(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : Ida(spec, dynamics, start,
            SupportConstraints(dynamics.cable().supports().spec(), dynamics.cable().supports().direction(),
                               dynamics.cable().nodes())) {}

  long rejected_steps() const override {
    long error_failures = 0, convergence_failures = 0;
    IDAGetNumErrTestFails(ida_.get(), &error_failures);
    IDAGetNumNonlinSolvConvFails(ida_.get(), &convergence_failures);
    return error_failures + convergence_failures;
  }

  void constraint_forces(double t, Eigen::VectorXd& lambda) const override {
    lambda = sundials::part(y_at(t), 2 * f_.size(), constraints_.count());
  }

 private:
  Ida(const MethodSpec& spec, Dynamics& dynamics, const State& start, const SupportConstraints& constraints)
      : LibraryMethod(dynamics, start, (spec.parameters.at("stabilised") != 0 ? 2 : 1) * constraints.count()),
        share_(sundials::multistep_share(*spec.rtol, static_cast<int>(spec.parameters.at("max_order")))),
        rtol_(share_ * *spec.rtol),
        absolute_(absolute_tolerances(share_ * *spec.atol)),
        constraints_(constraints),
        stabilised_(spec.parameters.at("stabilised") != 0),
        held_(constraints.apply(start.q)),
        q_(start.q),
        f_(start.q),
        rates_(start.q),
        system_(dynamics, constraints_, stabilised_),
        matrix_(sundials::make_matrix(context())),
        solver_(sundials::make_solver(system_, context())),
        yp_(sundials::make_vector(N_VGetLength(y()), context())),
        ida_(IDACreate(context())) {
    if (!ida_) throw std::bad_alloc();
    const Eigen::Index n = f_.size();
    const sundials::Vector differential = sundials::make_vector(N_VGetLength(y()), context());
    sundials::part(differential.get(), 0, 2 * n).setOnes();
    start_consistently(start, yp_.get());
    void* ida = ida_.get();
    IDAInit(ida, residual, start.t, y(), yp_.get());
    IDASetUserData(ida, static_cast<LibraryMethod*>(this));
    IDASetErrHandlerFn(ida, sundials::keep_message, &message());
    IDAWFtolerances(ida, weigh);
    IDASetId(ida, differential.get());
    IDASetSuppressAlg(ida, SUNTRUE);
    IDASetLinearSolver(ida, solver_.get(), matrix_.get());
    IDASetJacFn(ida, jacobian);
    // A scaled correction would meet the constraints in part only, and the rest, extrapolated, would grow.
    IDASetLinearSolutionScaling(ida, SUNFALSE);
    // Without the scaling an old c costs iterations: a tenth off is enough for a new matrix.
    IDASetDeltaCjLSetup(ida, 0.1);
    IDASetMaxOrd(ida, static_cast<int>(spec.parameters.at("max_order")));
  }

  /// λ and y' at the start, from its accelerations.
  void start_consistently(const State& start, N_Vector yp) {
    const Eigen::Index n = f_.size();
    Eigen::VectorXd a = start.q;
    dynamics().acceleration(start, a);
    // What is wrong with the start itself is found by the first step.
    dynamics().take_collapsed();
    force(start.t, start.q, start.v);
    dynamics().cable().mass().multiply(a, rates_);
    rates_ -= f_;
    sundials::part(y(), 2 * n, constraints_.count()) = constraints_.apply(rates_);
    sundials::q_of(yp, n) = start.v;
    sundials::v_of(yp, n) = a;
  }

  /// f_ := the forces on the cable but for those of the joint. Returns an element whose slope collapsed.
  std::optional<int> force(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    dynamics().free_force(q, f_, {t, v.data()});
    return dynamics().take_collapsed();
  }

  static int residual(double t, N_Vector y, N_Vector yp, N_Vector r, void* user_data) {
    auto& self = static_cast<Ida&>(*static_cast<LibraryMethod*>(user_data));
    return self.evaluate(t, y, yp, r);
  }

  int evaluate(double t, N_Vector y, N_Vector yp, N_Vector r) {
    const Eigen::Index n = f_.size(), m = constraints_.count();
    const auto v = sundials::v_of(y, n);
    q_ = sundials::q_of(y, n);
    rates_ = v;
    if (const auto element = force(t, q_, rates_)) {
      note_collapsed(*element);
      return 1;
    }
    if (!f_.allFinite()) return 1;
    constraints_.add_transposed(sundials::part(y, 2 * n, m), f_);
    rates_ = sundials::v_of(yp, n);
    dynamics().cable().mass().multiply(rates_, inertia_);
    sundials::v_of(r, n) = inertia_ - f_;
    rates_ = v;
    if (stabilised_) {
      constraints_.add_transposed(sundials::part(y, 2 * n + m, m), rates_);
      sundials::part(r, 2 * n + m, m) = constraints_.apply(q_) - held_;
    }
    sundials::q_of(r, n) = sundials::q_of(yp, n) - rates_;
    sundials::part(r, 2 * n, m) = constraints_.apply(v);
    return 0;
  }

  /// The multipliers weigh nothing: they are as rough as the accelerations, μ is all round-off, and neither q
  /// nor v depends on how well they have converged.
  static int weigh(N_Vector y, N_Vector weights, void* user_data) {
    const auto& self = static_cast<const Ida&>(*static_cast<LibraryMethod*>(user_data));
    const Eigen::Index n = 2 * self.f_.size();
    sundials::part(weights, 0, N_VGetLength(y)).setZero();
    sundials::part(weights, 0, n) = (self.rtol_ * sundials::part(y, 0, n).array().abs() +
                                     sundials::part(self.absolute_.get(), 0, n).array())
                                        .inverse();
    return 0;
  }

  static int jacobian(double t, double leading, N_Vector y, N_Vector, N_Vector, SUNMatrix, void* user_data,
                      N_Vector, N_Vector, N_Vector) {
    return static_cast<Ida&>(*static_cast<LibraryMethod*>(user_data)).system_.prepare(t, y, leading);
  }

  int evolve(double stop, double& reached) override {
    void* ida = ida_.get();
    IDASetStopTime(ida, stop);
    const int flag = IDASolve(ida, stop, &reached, y(), yp_.get(), IDA_ONE_STEP);
    IDAGetNumNonlinSolvIters(ida, &dynamics().counters.newton_iterations);
    return flag;
  }

  void dense_output(double t, N_Vector to) const override { IDAGetDky(ida_.get(), t, 0, to); }

  double share_, rtol_;
  sundials::Vector absolute_;
  SupportConstraints constraints_;
  bool stabilised_;
  Eigen::VectorXd held_;  // G q₀
  Eigen::VectorXd q_, f_, rates_, inertia_;
  sundials::IdaLinearSystem system_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
  sundials::Vector yp_;  // y'
  std::unique_ptr<void, FreeIda> ida_;
};

}  // namespace

MethodEntry ida_entry() {
  MethodInfo info;
  info.name = "ida";
  info.summary = "SUNDIALS IDA: backward differentiation with the joint as constraints with multipliers";
  info.source = "Gear, Gupta, Leimkuhler 1985; Hindmarsh et al. 2005";
  info.order = "1 to 5";
  info.conserves = "momentum";
  info.use = "the reaction of the joint, and how far it drifts";
  info.family = MethodFamily::constrained;
  info.implicit = true;
  info.takes_tolerances = true;
  info.cost = {4500, 6000};
  info.parameters = {{.name = "max_order",
                      .meaning = "highest order used; 2 and below are stable at every oscillation",
                      .minimum = 1,
                      .maximum = 5,
                      .fallback = 5,
                      .whole = true},
                     {.name = "stabilised",
                      .meaning = "1 holds the joint in position and in velocity, 0 in velocity only",
                      .minimum = 0,
                      .maximum = 1,
                      .fallback = 1,
                      .whole = true}};
  return {info, made<Ida>};
}

}  // namespace plumb
