#include "engine/model/compression_limit.h"

#include <Eigen/Geometry>

#include "engine/model/cable.h"

namespace plumb {

std::optional<OverloadedElement> overloaded_element(const Cable& cable, const Eigen::VectorXd& q,
                                                    double fraction) {
  const bool first_free = !cable.supports().first().position, last_free = !cable.supports().last().position;
  if (!cable.variable_loads().empty()) return std::nullopt;
  if (!cable.constants().green || (!first_free && !last_free)) return std::nullopt;
  const auto load = [&](int node) -> Vec3 { return fraction * cable.external_force().segment<3>(6 * node); };
  OverloadedElement hardest{-1, green_compression_limit};
  // What lies between an element and the free end is held by the element alone.
  Vec3 beyond = Vec3::Zero();
  for (int k = 0; k < cable.elements(); ++k) {
    const int element = last_free ? cable.elements() - 1 - k : k;
    beyond += load(last_free ? element + 1 : element);
    const Vec3 chord = (q.segment<3>(6 * element + 6) - q.segment<3>(6 * element)).normalized();
    const double pull = (last_free ? 1 : -1) * beyond.dot(chord);
    const double compression = -pull / cable.constants().axial_stiffness;
    if (compression > hardest.compression) hardest = {element, compression};
  }
  return hardest.element < 0 ? std::nullopt : std::optional(hardest);
}

}  // namespace plumb
