#include "engine/integrate/sundials_support.h"

#include <fmt/format.h>

#include <new>

namespace plumb::sundials {

Context::Context() {
  if (SUNContext_Create(nullptr, &context_) != 0) throw std::bad_alloc();
}

Context::~Context() {
  SUNContext_Free(&context_);
}

Vector make_vector(const State& state, const Context& context) {
  Vector y(N_VNew_Serial(2 * state.q.size(), context));
  if (!y) throw std::bad_alloc();
  q_of(y.get()) = state.q;
  v_of(y.get()) = state.v;
  return y;
}

Eigen::Map<Eigen::VectorXd> q_of(N_Vector y) {
  return {N_VGetArrayPointer(y), N_VGetLength(y) / 2};
}

Eigen::Map<Eigen::VectorXd> v_of(N_Vector y) {
  const auto half = N_VGetLength(y) / 2;
  return {N_VGetArrayPointer(y) + half, half};
}

int RightHandSide::evaluate(double, N_Vector y, N_Vector ydot, void* user_data) {
  auto& self = *static_cast<RightHandSide*>(user_data);
  self.q = q_of(y);
  self.dynamics.acceleration(self.q, self.a);
  if (const auto element = self.dynamics.take_collapsed()) {
    self.collapsed_element = *element;
    return 1;
  }
  if (!self.a.allFinite()) return 1;
  q_of(ydot) = v_of(y);
  v_of(ydot) = self.a;
  return 0;
}

void keep_message(int code, const char*, const char*, char* message, void* data) {
  // Warnings (codes above 0) do not end a run.
  if (code < 0) *static_cast<std::string*>(data) = message;
}

StepResult failure(const std::string& function, int flag, const std::string& message,
                   const RightHandSide& rhs) {
  if (rhs.collapsed_element >= 0) return {Outcome::singular, "the slope collapsed", rhs.collapsed_element};
  return {Outcome::no_convergence,
          fmt::format("{} gave up ({}){}{}", function, flag, message.empty() ? "" : ": ", message), -1};
}

}  // namespace plumb::sundials
