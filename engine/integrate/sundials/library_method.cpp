#include "engine/integrate/sundials/library_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string_view>

#include "engine/model/cable.h"

namespace plumb::sundials {
namespace {

/// What the library spends most of its time on, as vectors are short and formulas have many stages: its own
/// adds one vector after the other to what is in memory, with the zeros of a formula's table.
int linear_combination(int count, double* factors, N_Vector* vectors, N_Vector sum) {
  constexpr int most = 32;
  if (count > most) return N_VLinearCombination_Serial(count, factors, vectors, sum);
  std::array<const double*, most> from;
  std::array<double, most> times;
  std::size_t used = 0;
  for (int k = 0; k < count; ++k) {
    if (factors[k] == 0) continue;
    from[used] = N_VGetArrayPointer(vectors[k]);
    times[used++] = factors[k];
  }
  double* const to = N_VGetArrayPointer(sum);
  const Eigen::Index size = N_VGetLength(sum);
  const auto add_up = [&]<int width>(Eigen::Index at) {
    using Part = Eigen::Array<double, width, 1>;
    Part part = Part::Zero();
    for (std::size_t k = 0; k < used; ++k) part += times[k] * Eigen::Map<const Part>(from[k] + at);
    Eigen::Map<Part>(to + at) = part;
  };
  constexpr int wide = 12;
  Eigen::Index at = 0;
  for (; at + wide <= size; at += wide) add_up.operator()<wide>(at);
  for (; at < size; ++at) add_up.operator()<1>(at);
  return 0;
}

/// A message of the library without "At t = … and h = …, ", which are in the units of the computation and are
/// told with every failure.
std::string_view without_times(std::string_view message) {
  constexpr std::string_view begins = "At t = ", ends = ", ";
  const std::size_t end = message.find(ends);
  return message.starts_with(begins) && end != message.npos ? message.substr(end + ends.size()) : message;
}

}  // namespace

Context::Context() {
  if (SUNContext_Create(nullptr, &context_) != 0) throw std::bad_alloc();
}

Context::~Context() {
  SUNContext_Free(&context_);
}

Vector make_vector(Eigen::Index size, const Context& context) {
  Vector y(N_VNew_Serial(size, context));
  if (!y) throw std::bad_alloc();
  // Many vectors at once, where there would be a call for each pair.
  N_VEnableFusedOps_Serial(y.get(), SUNTRUE);
  y->ops->nvlinearcombination = linear_combination;
  part(y.get(), 0, size).setZero();
  return y;
}

Eigen::Map<Eigen::VectorXd> part(N_Vector y, Eigen::Index first, Eigen::Index count) {
  return {N_VGetArrayPointer(y) + first, count};
}

double multistep_share(double rtol, int highest_order) {
  constexpr double loose = 1e-4;  // few steps beyond those that the motion itself takes
  return std::min(1.0, std::pow(rtol / loose, 1.0 / highest_order));
}

void keep_message(int code, const char*, const char*, char* message, void* data) {
  // Warnings (codes above 0) do not end a run.
  if (code < 0) *static_cast<std::string*>(data) = message;
}

LibraryMethod::LibraryMethod(Dynamics& dynamics, const State& start, Eigen::Index extra)
    : dynamics_(dynamics),
      y_(make_vector(2 * start.q.size() + extra, context_)),
      between_(make_vector(2 * start.q.size() + extra, context_)),
      state_(start),
      q_(start.q),
      a_(start.q) {
  q_of(y(), start.q.size()) = start.q;
  v_of(y(), start.q.size()) = start.v;
}

Vector LibraryMethod::absolute_tolerances(double atol) const {
  Vector result = make_vector(N_VGetLength(y()), context_);
  const Eigen::Index n = state_.q.size();
  Eigen::VectorXd allowed = Eigen::VectorXd::Constant(n, atol);
  scale_nodal(dynamics_.cable().length(), 1, allowed);
  q_of(result.get(), n) = allowed;
  v_of(result.get(), n) = allowed / dynamics_.times().own;
  return result;
}

int LibraryMethod::right_hand_side(double t, N_Vector y, N_Vector ydot, void* user_data) {
  auto& self = *static_cast<LibraryMethod*>(user_data);
  const Eigen::Index n = self.q_.size();
  self.q_ = q_of(y, n);
  self.dynamics_.acceleration(Sum(self.q_), self.a_, {t, v_of(y, n).data()});
  if (const auto element = self.dynamics_.take_collapsed()) {
    self.note_collapsed(*element);
    return 1;
  }
  if (!self.a_.allFinite()) return 1;
  q_of(ydot, n) = v_of(y, n);
  v_of(ydot, n) = self.a_;
  return 0;
}

StepResult LibraryMethod::step(double stop) {
  collapsed_element_ = -1;
  double reached = state_.t;
  const int flag = evolve(stop, reached);
  if (flag < 0 && collapsed_element_ >= 0)
    return {Outcome::singular, "the slope collapsed", collapsed_element_};
  if (flag < 0)
    return {
        Outcome::no_convergence,
        fmt::format("SUNDIALS gave up ({}){}{}", flag, message_.empty() ? "" : ": ", without_times(message_)),
        -1};
  const Eigen::Index n = state_.q.size();
  state_.t = reached;
  state_.q = q_of(y(), n);
  state_.v = v_of(y(), n);
  return {};
}

N_Vector LibraryMethod::y_at(double t) const {
  if (t == state_.t) return y();
  dense_output(t, between_.get());
  return between_.get();
}

void LibraryMethod::interpolate(double t, State& at) const {
  N_Vector there = y_at(t);
  at.t = t;
  at.q = q_of(there, state_.q.size());
  at.v = v_of(there, state_.q.size());
}

}  // namespace plumb::sundials
