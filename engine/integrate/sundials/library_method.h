#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <memory>
#include <string>

#include "engine/integrate/method.h"

namespace plumb::sundials {

/// The library's context, owned.
class Context {
 public:
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  operator SUNContext() const { return context_; }

 private:
  SUNContext context_ = nullptr;
};

struct DestroyVector {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
/// The library's vector, owned.
using Vector = std::unique_ptr<_generic_N_Vector, DestroyVector>;

/// A vector of that many zeros. Throws std::bad_alloc.
Vector make_vector(Eigen::Index size, const Context& context);

/// `count` numbers of y from `first` on.
Eigen::Map<Eigen::VectorXd> part(N_Vector y, Eigen::Index first, Eigen::Index count);

/// The coordinates and the rates in y = (q, v, …), n numbers each.
inline Eigen::Map<Eigen::VectorXd> q_of(N_Vector y, Eigen::Index n) {
  return part(y, 0, n);
}
inline Eigen::Map<Eigen::VectorXd> v_of(N_Vector y, Eigen::Index n) {
  return part(y, n, n);
}

/// The factor by which tolerances are made tighter for multistep formulas of up to that order. They keep the
/// error of each step to it, of which there are the more the tighter it is, and errors add up: left alone
/// they would shrink as the tolerance to the power order/(order + 1).
double multistep_share(double rtol, int highest_order);

/// Takes the library's error messages instead of standard error; `data` is a std::string.
void keep_message(int code, const char* module, const char* function, char* message, void* data);

/// What the methods of the library share: the vector y = (q, v, …) and the state it stands for. Nothing is
/// allocated after the start.
class LibraryMethod : public Method {
 public:
  /// `extra`: how many unknowns y holds beside q and v; they start at 0.
  LibraryMethod(Dynamics& dynamics, const State& start, Eigen::Index extra = 0);

  const State& state() const final { return state_; }
  StepResult step(double stop) final;
  void interpolate(double t, State& at) const final;

 protected:
  /// Calls the library for one step that ends at `stop` at the latest; sets `reached` and returns its flag.
  virtual int evolve(double stop, double& reached) = 0;
  /// Sets y to the library's interpolant at t within the last step.
  virtual void dense_output(double t, N_Vector y) const = 0;

  /// Right-hand side of q' = v, v' = M⁻¹ f(t, q, v) in the library's form; `user_data` is a LibraryMethod.
  /// Returns 1 (try a shorter step) where the accelerations are not finite or a slope collapsed.
  static int right_hand_side(double t, N_Vector y, N_Vector ydot, void* user_data);

  /// Remembers where a slope collapsed within the step, in case that the library gives up for it.
  void note_collapsed(int element) { collapsed_element_ = element; }

  /// atol of positions, slopes and their rates, in a vector like y: atol times L, 1, L/T and 1/T.
  Vector absolute_tolerances(double atol) const;

  Dynamics& dynamics() { return dynamics_; }
  const Context& context() const { return context_; }
  N_Vector y() const { return y_.get(); }
  /// y at t: the state's own, or the interpolant. Good until the next call.
  N_Vector y_at(double t) const;
  /// The library's last error message, for keep_message.
  std::string& message() { return message_; }

 private:
  Context context_;
  Dynamics& dynamics_;
  Vector y_;
  Vector between_;
  State state_;
  Eigen::VectorXd q_, a_;
  int collapsed_element_ = -1;
  std::string message_;
};

}  // namespace plumb::sundials
