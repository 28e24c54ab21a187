#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/base/number_text.h"
#include "engine/model/supports.h"
#include "engine/read/case_sections.h"
#include "engine/read/model_keys.h"

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
  table.read(cable, has_mesh);
  table.finish();
  for (const std::string_view key : foreign_keys(cable.model))
    if (table.has(key))
      table.refuse_value(key, cable.model == CableModel::chain
                                  ? "not a key of a chain, whose links only stretch"
                                  : "not a key of a rigid rod, which does not deform");

  const double circular = cable.area * cable.area / (4 * std::numbers::pi);
  const bool bends = cable.model == CableModel::cable, has_second_moment = table.has("second_moment");
  if (bends && !has_second_moment) cable.second_moment = circular;
  check_product(table, cable.density * cable.area * cable.length, "density",
                "the mass, density × area × length,");
  check_product(table, cable.youngs_modulus * cable.area, "youngs_modulus",
                "the stiffness, youngs_modulus × area,");
  if (!std::isfinite(cable.youngs_modulus * cable.second_moment)) {
    table.refuse_value(has_second_moment ? "second_moment" : "area", "the bending stiffness is not finite");
  }
  return cable;
}

void check_accuracy(const TableReader& table, double tolerance, const CableSpec& cable) {
  if (tolerance > cable.length)
    table.refuse_value("tolerance",
                       fmt::format("must be at most the length of the cable, {:g} m", cable.length));
}

StartSpec read_start(TableReader table) {
  StartSpec start;
  table.read(start);
  table.finish();

  // Scaled by its largest component first: the square of a tiny or huge one is not a number to divide by.
  const double largest = start.direction.cwiseAbs().maxCoeff();
  if (largest == 0) table.refuse_value("direction", "must not be zero");
  start.direction = (start.direction / largest).normalized();
  return start;
}

SupportsSpec read_supports(TableReader table, CableModel model) {
  SupportsSpec supports;
  table.read(supports);
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

}  // namespace plumb
