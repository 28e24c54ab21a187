#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// What a path of equilibria does where its stiffness changes the number of its negative eigenvalues.
enum class CriticalKind {
  limit_point,  ///< the load has an extremum: beyond it no equilibrium is near
  bifurcation,  ///< another path crosses
};

/// Both, in the order above.
std::span<const CriticalKind> critical_kinds();
inline std::span<const CriticalKind> enum_values(CriticalKind) {
  return critical_kinds();
}
/// "limit-point", "bifurcation".
std::string_view word(CriticalKind);
/// The same in running text: "limit point".
std::string_view in_words(CriticalKind);

/// A point on a path of equilibria.
struct PathPoint {
  double load = 0;          ///< as a fraction of the whole load
  double displacement = 0;  ///< greatest distance of a node from its place at the start, m
  int negative = 0;         ///< negative eigenvalues of the stiffness; -1: they cannot be counted
  bool joined = true;       ///< to the point before it by a path; false where the cable went over to another
};

/// A point at which a path of equilibria gains or loses stability.
struct CriticalPoint {
  CriticalKind kind = CriticalKind::limit_point;
  double load = 0;          ///< as a fraction of the whole load; known to 1e-6
  double displacement = 0;  ///< as of a PathPoint, m
  int negative_before = 0;  ///< negative eigenvalues of the stiffness on either side of it
  int negative_after = 0;
  double at = 0;                      ///< where its mode moves most, as a fraction of the length
  std::array<double, 3> direction{};  ///< in which it moves there, a unit vector
  std::string what_followed;          ///< how the run went on from there: "onto the stable branch …"
};

/// What a method of statics knows of the equilibria that it found; empty of one that integrates motion.
struct Equilibria {
  std::vector<int> negative_eigenvalues;  ///< of the stiffness at each output; -1: they cannot be counted
  std::vector<PathPoint> path;
  std::vector<CriticalPoint> critical_points;
};

}  // namespace plumb
