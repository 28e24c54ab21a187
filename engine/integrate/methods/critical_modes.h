#pragma once

#include "engine/integrate/methods/loaded_cable.h"

namespace plumb {

/// The direction in which a cable gives way where its stiffness has an eigenvalue of 0.
struct CriticalMode {
  Eigen::VectorXd shape;    ///< of norm 1 (LoadedCable::norm)
  double at = 0;            ///< where it moves most, as a fraction of the length
  Vec3 direction{0, 0, 0};  ///< in which it moves there, a unit vector
  bool by_load = false;     ///< the load says to which side; else both are alike
  bool gives_way = false;   ///< its eigenvalue is as good as 0 beside that of the first bending vibration
};

/// The mode of an equilibrium next to a critical point, at which eigenvalues of K are near 0, with the K that
/// is factored. Of several modes that combination, and of two sides that one, to which the load does work;
/// where it does none (`by_load` false) the mode moves most along one axis, y before z before x, and to its
/// positive side.
CriticalMode critical_mode(LoadedCable& loaded);

}  // namespace plumb
