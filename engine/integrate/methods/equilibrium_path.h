#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/integrate/equilibria.h"
#include "engine/integrate/methods/critical_modes.h"
#include "engine/integrate/methods/loaded_cable.h"

namespace plumb {

/// Where a path of equilibria is followed to beyond a critical point.
enum class Follow {
  stable,   ///< onto what the cable would go to under a load that grows slowly
  primary,  ///< along the path that it is on, whether the cable would stay there or not
};

/// "that moves most at 0.5 of the length, along (0, 1, 0)": the mode of a critical point.
std::string mode_in_words(const CriticalPoint& point);

/// "2 negative eigenvalues"; of -1, which cannot be counted, "an eigenvalue that is not positive".
std::string eigenvalues_in_words(int negative);

/// The equilibria of a cable under a load that grows from 0, followed by arc length with corrections in the
/// plane normal to the path (Riks 1979, Int. J. Solids Structures 15, 529-551; each correction by two
/// solutions with the same factors, Crisfield 1981, Computers & Structures 13, 55-62). The step along the
/// path is chosen by how far the corrections lead and the path turns, and never by where an equilibrium is
/// asked for, so that the branch which is found does not depend on that.
///
/// The stiffness loses an eigenvalue only at a limit point or a bifurcation. Where the count of its negative
/// ones changes, the step is halved until that is known to 1e-7 of the load.
class EquilibriumPath {
 public:
  /// Must outlive `loaded`, whose start is that of the path. Throws nothing; whether there is a stable
  /// equilibrium to begin with is said by `beginning`.
  EquilibriumPath(LoadedCable& loaded, Follow follow, int iterations);

  StepResult beginning() const { return beginning_; }
  /// Where it begins, unloaded; empty where `beginning` is a failure.
  const Eigen::VectorXd& start() const { return start_; }

  /// An equilibrium under a share of the load.
  struct Found {
    double share = 0;
    Eigen::VectorXd q;
    int negative = 0;  ///< negative eigenvalues; -1: they cannot be counted
  };

  /// Follows the path until it comes to that share of the load, which must be more than the one before.
  StepResult reach(double share, Found& found);
  /// The equilibrium on the path at a share of the load between the last two that were reached.
  StepResult between(double share, Found& found);

  /// The path so far.
  const std::vector<PathPoint>& points() const { return points_; }
  const std::vector<CriticalPoint>& critical_points() const { return critical_points_; }

 private:
  struct Node {
    double share = 0;
    Eigen::VectorXd q;
    double d_share = 0;  // direction of the path, of unit length together
    Eigen::VectorXd dq;
    int negative = 0;
    bool joined = true;
  };
  struct Attempt {
    bool ok = false;
    int iterations = 0;
    double straightness = 0;  // cosine of the angle by which the path turned
    StepResult failure;
  };

  /// Corrects a guess in the plane normal to (normal, normal_share) through it. `reach`: how far, at most.
  StepResult correct(const Eigen::VectorXd& normal, double normal_share, double reach, Node& node,
                     int& iterations);
  /// Sets the direction of the path at a node, at which K is factored, towards (dq, d_share).
  bool set_direction(const Eigen::VectorXd& dq, double d_share, Node& node);
  Attempt attempt(const Node& from, double step, Node& to);
  /// Adds the next point to the path.
  StepResult advance();
  /// Names the critical point between two nodes that are `step` apart and goes on beyond it.
  StepResult pass(const Node& before, const Node& after, double step);
  /// Onto the stable branch that begins at `from`, if there is one.
  bool branch_off(const Node& from, const CriticalMode& mode, std::string& what_followed);
  /// To another equilibrium, by damped motion from `from`, pushed along `kick`.
  StepResult go_over(const Node& from, const Eigen::VectorXd& kick, std::string& what_followed);
  /// Goes on where the path turns too sharply to be followed, as at a bifurcation that is disturbed by so
  /// little that it cannot be told from one. False, with more in `why`, where there is nothing to go on to.
  bool turn_off(StepResult& why);
  CriticalPoint& note_critical(CriticalKind kind, const Node& before, const Node& after,
                               const CriticalMode& mode, double share);
  void append(Node node);
  StepResult locate(std::size_t first, double share, Found& found);
  /// First of two neighbouring nodes between which the share of the load lies, from `first` on.
  std::optional<std::size_t> around(std::size_t first, double share) const;

  LoadedCable& loaded_;
  Follow follow_;
  int iterations_;
  double step_;
  int good_ = 0;          // steps taken since one failed
  bool is_fine_ = false;  // the mesh, so that round-off is near
  std::vector<Node> nodes_;
  std::size_t last_ = 0;  // node before the equilibrium that was reached last
  std::vector<PathPoint> points_;
  std::vector<CriticalPoint> critical_points_;
  StepResult beginning_, failure_;
  Eigen::VectorXd start_;
  long attempts_ = 0;
  Eigen::VectorXd residual_, by_residual_, by_load_;
};

}  // namespace plumb
