#include <arkode/arkode_erkstep.h>

#include <new>

#include "engine/integrate/library_method.h"

namespace plumb {
namespace {

struct FreeErk {
  void operator()(void* memory) const { ERKStepFree(&memory); }
};

ARKODE_ERKTableID table_of_order(int order) {
  switch (order) {
    case 2:
      return ARKODE_HEUN_EULER_2_1_2;
    case 3:
      return ARKODE_BOGACKI_SHAMPINE_4_2_3;
    case 4:
      return ARKODE_ZONNEVELD_5_3_4;
    case 5:
      return ARKODE_DORMAND_PRINCE_7_4_5;
    case 6:
      return ARKODE_VERNER_8_5_6;
    default:
      return ARKODE_FEHLBERG_13_7_8;
  }
}

/// ARKODE's embedded explicit Runge-Kutta pairs with controlled step (Reynolds et al. 2023). Steps end on the
/// output times, as the library's interpolation is of lower order than its pairs.
class ArkodeErk : public sundials::LibraryMethod {
 public:
  ArkodeErk(const MethodSpec& spec, Dynamics& dynamics, const State& start)
      : LibraryMethod(dynamics, start),
        erk_(ERKStepCreate(sundials::RightHandSide::evaluate, start.t, y(), context())) {
    if (!erk_) throw std::bad_alloc();
    void* erk = erk_.get();
    ERKStepSetUserData(erk, &right_hand_side());
    ERKStepSStolerances(erk, *spec.rtol, *spec.atol);
    ERKStepSetErrHandlerFn(erk, sundials::keep_message, &message());
    ERKStepSetTableNum(erk, table_of_order(static_cast<int>(spec.parameters.at("order"))));
  }

  bool stops_at_outputs() const override { return true; }

  long rejected_steps() const override {
    long failures = 0;
    ERKStepGetNumErrTestFails(erk_.get(), &failures);
    return failures;
  }

 private:
  int evolve(double stop, double& reached) override {
    ERKStepSetStopTime(erk_.get(), stop);
    return ERKStepEvolve(erk_.get(), stop, y(), &reached, ARK_ONE_STEP);
  }

  void dense_output(double t, N_Vector to) const override { ERKStepGetDky(erk_.get(), t, 0, to); }

  std::unique_ptr<void, FreeErk> erk_;
};

}  // namespace

MethodEntry arkode_erk_entry() {
  MethodInfo info;
  info.name = "arkode-erk";
  info.summary = "SUNDIALS ARKODE: embedded explicit Runge-Kutta pairs with controlled step";
  info.source = "Reynolds et al. 2023; Fehlberg 1968 for order 8";
  info.order = "2 to 8";
  info.conserves = "momentum";
  info.use = "soft, coarse cables, and references";
  info.family = MethodFamily::explicit_one_step;
  info.takes_tolerances = true;
  info.parameters = {{.name = "order",
                      .meaning = "2 Heun-Euler, 3 Bogacki-Shampine, 4 Zonneveld, 5 Dormand-Prince, 6 Verner, "
                                 "7 and 8 Fehlberg's pair of order 8",
                      .minimum = 2,
                      .maximum = 8,
                      .fallback = 8,
                      .whole = true}};
  return {info,
          [](const MethodSpec& spec, Dynamics& dynamics, const State& start) -> std::unique_ptr<Method> {
            return std::make_unique<ArkodeErk>(spec, dynamics, start);
          }};
}

}  // namespace plumb
