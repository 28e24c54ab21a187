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
/// y = (q, v) as the library's vector, owned.
using Vector = std::unique_ptr<_generic_N_Vector, DestroyVector>;

/// A vector of 2n numbers. Throws std::bad_alloc.
Vector make_vector(const State& state, const Context& context);

/// The halves of y = (q, v).
Eigen::Map<Eigen::VectorXd> q_of(N_Vector y);
Eigen::Map<Eigen::VectorXd> v_of(N_Vector y);

/// Right-hand side of q' = v, v' = M⁻¹ f(q) in the library's form; `user_data` is a RightHandSide.
/// Returns 1 (try a shorter step) where the accelerations are not finite or a slope collapsed.
struct RightHandSide {
  Dynamics& dynamics;
  Eigen::VectorXd q, a;
  int collapsed_element = -1;  ///< where the last failure was

  static int evaluate(double t, N_Vector y, N_Vector ydot, void* user_data);
};

/// Takes the library's error messages instead of standard error; `data` is a std::string.
void keep_message(int code, const char* module, const char* function, char* message, void* data);

/// What the methods of the library share: the vector y = (q, v) and the state it stands for.
class LibraryMethod : public Method {
 public:
  LibraryMethod(Dynamics& dynamics, const State& start);

  const State& state() const final { return state_; }
  StepResult step(double stop) final;
  void interpolate(double t, State& at) const final;

 protected:
  /// Calls the library for one step that ends at `stop` at the latest; sets `reached` and returns its flag.
  virtual int evolve(double stop, double& reached) = 0;
  /// Sets y to the library's interpolant at t within the last step.
  virtual void dense_output(double t, N_Vector y) const = 0;

  const Context& context() const { return context_; }
  RightHandSide& right_hand_side() { return right_hand_side_; }
  N_Vector y() { return y_.get(); }
  /// The library's last error message, for keep_message.
  std::string& message() { return message_; }

 private:
  Context context_;
  RightHandSide right_hand_side_;
  Vector y_;
  State state_;
  std::string message_;
};

}  // namespace plumb::sundials
