#include "engine/model/integration_points.h"

#include "engine/model/hermite.h"
#include "engine/model/quadrature.h"

namespace plumb {
namespace {

std::vector<IntegrationPoint> integration_points(std::span<const QuadraturePoint> rule, double l) {
  std::vector<IntegrationPoint> points;
  for (const QuadraturePoint& p : rule)
    points.push_back({p.weight * l, Hermite::slopes(p.x, l), Hermite::curvatures(p.x, l)});
  return points;
}

}  // namespace

std::vector<IntegrationPoint> stretching_points(const ElementConstants& element) {
  return integration_points(stretching_rule(element.full), element.length);
}

std::vector<IntegrationPoint> bending_points(const ElementConstants& element) {
  return integration_points(bending_rule(element.full), element.length);
}

}  // namespace plumb
