#include "engine/integrate/library_method.h"

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

LibraryMethod::LibraryMethod(Dynamics& dynamics, const State& start)
    : right_hand_side_{dynamics, {}, {}}, y_(make_vector(start, context_)), state_(start) {}

StepResult LibraryMethod::step(double stop) {
  right_hand_side_.collapsed_element = -1;
  double reached = state_.t;
  const int flag = evolve(stop, reached);
  if (flag < 0 && right_hand_side_.collapsed_element >= 0)
    return {Outcome::singular, "the slope collapsed", right_hand_side_.collapsed_element};
  if (flag < 0)
    return {Outcome::no_convergence,
            fmt::format("SUNDIALS gave up ({}){}{}", flag, message_.empty() ? "" : ": ", message_), -1};
  state_.t = reached;
  state_.q = q_of(y_.get());
  state_.v = v_of(y_.get());
  return {};
}

void LibraryMethod::interpolate(double t, State& at) const {
  const Vector y(N_VClone(y_.get()));
  if (!y) throw std::bad_alloc();
  dense_output(t, y.get());
  at.t = t;
  at.q = q_of(y.get());
  at.v = v_of(y.get());
}

}  // namespace plumb::sundials
