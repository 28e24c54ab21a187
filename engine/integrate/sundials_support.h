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

/// The outcome for a library's return value < 0.
StepResult failure(const std::string& function, int flag, const std::string& message,
                   const RightHandSide& rhs);

}  // namespace plumb::sundials
