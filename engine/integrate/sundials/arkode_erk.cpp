#include <arkode/arkode_erkstep.h>

#include <algorithm>
#include <new>
#include <utility>

#include "engine/integrate/sundials/arkode_method.h"
#include "engine/integrate/sundials/arkode_tables.h"

namespace plumb {
namespace {

struct FreeErk {
  void operator()(void* memory) const { ERKStepFree(&memory); }
};

/// The pair with the formula's own result as one more stage, of weight 0, whose rate is the first of the next
/// step. SUNDIALS 6.4 takes the last stage for that wherever it lies at the end of the step, which is wrong,
/// and costs order and stability, unless it holds the result; with this stage it always does, at no cost.
ArkodeTable with_result_as_last_stage(const ArkodeTable& pair) {
  const int s = pair->stages;
  ArkodeTable table(ARKodeButcherTable_Alloc(s + 1, SUNTRUE));
  if (!table) throw std::bad_alloc();
  table->q = pair->q;
  table->p = pair->p;
  for (int i = 0; i < s; ++i) {
    std::copy_n(pair->A[i], s, table->A[i]);
    table->c[i] = pair->c[i];
    table->A[s][i] = table->b[i] = pair->b[i];
    table->d[i] = pair->d[i];
  }
  table->c[s] = 1;
  return table;
}

/// The pair that advances with a formula of that order.
ArkodeTable make_table(int order) {
  ArkodeTable table = explicit_table(order);
  const int last = table->stages - 1;
  const bool ends_with_result = std::equal(table->b, table->b + last, table->A[last]) && table->b[last] == 0;
  return ends_with_result ? std::move(table) : with_result_as_last_stage(table);
}

/// ARKODE's embedded explicit Runge-Kutta pairs (Reynolds et al. 2023): of order 3 Bogacki and Shampine
/// 1989, 4 Zonneveld 1963, 5 Dormand and Prince 1980, 6 Verner 1978, 7 and 8 Fehlberg 1968.
class ArkodeErk : public sundials::ArkodeMethod {
 public:
  ArkodeErk(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : ArkodeMethod(spec, dynamics, start), erk_(ERKStepCreate(right_hand_side, start.t, y(), context())) {
    if (!erk_) throw std::bad_alloc();
    void* erk = erk_.get();
    ERKStepSetUserData(erk, static_cast<LibraryMethod*>(this));
    ERKStepSetErrHandlerFn(erk, sundials::keep_message, &message());
    ERKStepSetTable(erk, make_table(static_cast<int>(spec.parameters.at("order"))).get());
    if (has_fixed_step()) return;
    ERKStepSVtolerances(erk, *spec.rtol, absolute_tolerances(*spec.atol).get());
    // The estimated error is that of the lower formula of a pair: where it is the one that advances, the
    // controller has to count with its order, not with the embedded one's.
    if (spec.parameters.at("order") == 7)
      ERKStepSetAdaptivityMethod(erk, ARK_ADAPT_PID, SUNTRUE, SUNTRUE, nullptr);
  }

  long rejected_steps() const override {
    long failures = 0;
    ERKStepGetNumErrTestFails(erk_.get(), &failures);
    return failures;
  }

 private:
  void fix_step(double h) override { ERKStepSetFixedStep(erk_.get(), h); }
  void stop_at(double stop) override { ERKStepSetStopTime(erk_.get(), stop); }
  int take_step(double stop, double& reached) override {
    return ERKStepEvolve(erk_.get(), stop, y(), &reached, ARK_ONE_STEP);
  }
  void dense_output(double t, N_Vector to) const override { ERKStepGetDky(erk_.get(), t, 0, to); }

  std::unique_ptr<void, FreeErk> erk_;
};

}  // namespace

MethodEntry arkode_erk_entry() {
  MethodInfo info;
  info.name = "arkode-erk";
  info.summary = "SUNDIALS ARKODE: embedded explicit Runge-Kutta pairs";
  info.source = "Reynolds et al. 2023; Dormand and Prince 1980; Verner 1978; Fehlberg 1968";
  info.order = "2 to 8";
  info.conserves = "momentum";
  info.use = "soft, coarse cables, and references";
  info.family = MethodFamily::explicit_one_step;
  info.takes_step = true;
  info.takes_tolerances = true;
  info.varied = {"order", "order {:g}", {3, 5, 8}};
  info.cost = {2600, 1000};
  info.amplification = [](const MethodSpec& spec, double z) {
    return amplification(explicit_table(static_cast<int>(spec.parameters.at("order"))), z);
  };
  info.parameters = {{.name = "order",
                      .meaning =
                          "2 Heun-Euler, 3 Bogacki-Shampine, 4 Zonneveld, 5 Dormand-Prince, 6 Verner, "
                          "7 and 8 Fehlberg's pair of these orders, advanced with the one or the other",
                      .minimum = 2,
                      .maximum = 8,
                      .fallback = 8,
                      .whole = true}};
  return {info, made<ArkodeErk>};
}

}  // namespace plumb
