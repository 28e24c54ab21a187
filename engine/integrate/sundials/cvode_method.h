#pragma once

#include "engine/integrate/sundials/library_method.h"

namespace plumb::sundials {

struct FreeCvode {
  void operator()(void* memory) const;
};

/// What CVODE's two families of multistep formulas of variable order and step share (Hindmarsh et al. 2005).
/// A method of this kind adds the nonlinear solver.
class CvodeMethod : public LibraryMethod {
 public:
  /// `family`: CV_ADAMS or CV_BDF; takes rtol, atol and the parameter max_order of the specification.
  CvodeMethod(int family, const MethodSpec& spec, Dynamics& dynamics, const State& start);

  long rejected_steps() const final;

 protected:
  /// Keeps the count of Newton iterations up to date, for a method that has them.
  virtual void count_iterations() {}

  void* cvode() const { return cvode_.get(); }

 private:
  int evolve(double stop, double& reached) final;
  void dense_output(double t, N_Vector y) const final;

  std::unique_ptr<void, FreeCvode> cvode_;
};

}  // namespace plumb::sundials
