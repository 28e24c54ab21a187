#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/base/number_text.h"
#include "engine/model/supports.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

/// Numbers that are each in range can still have a product that is not.
void check_product(const TableReader& table, double product, std::string_view key, std::string_view meaning) {
  if (std::isfinite(product) && product > 0) return;
  table.refuse_value(
      key, fmt::format("{} comes to {}; must be greater than 0 and finite", meaning, number_text(product)));
}

}  // namespace

CableSpec read_cable(TableReader table, bool has_mesh) {
  CableSpec cable;
  cable.length = table.number("length", Range::positive("m"));
  cable.area = table.number("area", Range::positive("m²"));
  cable.density = table.number("density", Range::positive("kg/m³"));
  cable.youngs_modulus = table.number("youngs_modulus", Range::positive("Pa"));
  const auto second_moment = table.optional_number("second_moment", Range::at_least(0, "m⁴"));
  const Range elements = Range::whole_between(1, most_elements_of_a_cable);
  cable.elements =
      static_cast<int>(has_mesh ? table.number("elements", elements) : table.number("elements", elements, 0));
  cable.model = table.choice<CableModel>("model", CableModel::cable);
  cable.strain = table.choice<StrainModel>("strain", StrainModel::green_geometric);
  cable.quadrature = table.choice<QuadratureRule>("quadrature", QuadratureRule::full);
  table.finish();
  if (cable.model == CableModel::chain) {
    for (const char* key : {"second_moment", "quadrature"})
      if (table.has(key)) table.refuse_value(key, "not a key of a chain, whose links only stretch");
  }
  if (cable.model == CableModel::rigid) {
    for (const char* key : {"second_moment", "quadrature", "strain"})
      if (table.has(key)) table.refuse_value(key, "not a key of a rigid rod, which does not deform");
  }

  const double circular = cable.area * cable.area / (4 * std::numbers::pi);
  cable.second_moment = cable.model != CableModel::cable ? 0 : second_moment.value_or(circular);
  check_product(table, cable.density * cable.area * cable.length, "density",
                "the mass, density × area × length,");
  check_product(table, cable.youngs_modulus * cable.area, "youngs_modulus",
                "the stiffness, youngs_modulus × area,");
  if (!std::isfinite(cable.youngs_modulus * cable.second_moment)) {
    table.refuse_value(second_moment ? "second_moment" : "area", "the bending stiffness is not finite");
  }
  return cable;
}

double read_accuracy(TableReader& table, const CableSpec& cable, double fallback) {
  const double tolerance = table.number("tolerance", Range::positive("m"), fallback);
  if (tolerance > cable.length)
    table.refuse_value("tolerance",
                       fmt::format("must be at most the length of the cable, {:g} m", cable.length));
  return tolerance;
}

StartSpec read_start(TableReader table) {
  StartSpec start;
  start.direction = table.vector("direction", "", start.direction);
  start.angular_velocity = table.vector("angular_velocity", "rad/s", start.angular_velocity);
  start.slope_rates = table.choice<SlopeRates>("slope_rates", start.slope_rates);
  start.axial_speed = table.number("axial_speed", Range::any("m/s"), start.axial_speed);
  start.imperfection = table.number("imperfection", Range::any("m"), start.imperfection);
  table.finish();

  // Scaled by its largest component first: the square of a tiny or huge one is not a number to divide by.
  const double largest = start.direction.cwiseAbs().maxCoeff();
  if (largest == 0) table.refuse_value("direction", "must not be zero");
  start.direction = (start.direction / largest).normalized();
  return start;
}

SupportsSpec read_supports(TableReader table, CableModel model) {
  SupportsSpec supports;
  supports.first = table.choice<Support>("first", supports.first);
  supports.last = table.choice<Support>("last", supports.last);
  table.finish();
  const auto check = [&](const char* end, Support support) {
    if (model == CableModel::chain && hold_of(support).direction)
      table.refuse_value(end, "a chain does not bend, so that its ends can be free or pinned only");
  };
  if (model == CableModel::rigid) {
    const Hold first = hold_of(supports.first);
    if (!first.position || first.direction)
      table.refuse_value("first", "must be \"pinned\" for a rigid rod, which turns on a joint there");
    if (!hold_of(supports.last).none())
      table.refuse_value("last", "must be \"free\" for a rigid rod, which turns about its first end");
  }
  check("first", supports.first);
  check("last", supports.last);
  return supports;
}

LoadsSpec read_loads(TableReader table) {
  LoadsSpec loads;
  for (const LoadKey& key : load_keys) loads.*key.value = table.vector(key.name, key.unit, loads.*key.value);
  table.finish();
  return loads;
}

}  // namespace plumb
