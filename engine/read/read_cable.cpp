#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/base/number_text.h"
#include "engine/base/time_function.h"
#include "engine/integrate/method_info.h"
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

void make_unit(const TableReader& table, std::string_view key, Vec3& vector) {
  // Scaled by its largest component first: the square of a tiny or huge one is not a number to divide by.
  const double largest = vector.cwiseAbs().maxCoeff();
  if (largest == 0) table.refuse_value(key, "must not be zero");
  vector = (vector / largest).normalized();
}

/// The expressions in time of what moves supports: `visit(table, key, expression)`.
void visit_in_time(const SupportsSpec& supports, const auto& visit) {
  const auto motion = [&](const char* name, const std::optional<MotionSpec>& spec) {
    if (spec)
      visit_keys(*spec, [&](const Key& key, const std::string& text) { visit(name, key.name, text); });
  };
  motion("first_motion", supports.first_motion);
  motion("last_motion", supports.last_motion);
  if (supports.first_rotation) visit("first_rotation", "angle", supports.first_rotation->angle);
}

/// Refuses motions that no support takes.
void check_moved(const TableReader& table, const SupportsSpec& supports, CableModel model) {
  if (model == CableModel::rigid && supports.move())
    table.refuse_value(supports.first_motion  ? "first_motion"
                       : supports.last_motion ? "last_motion"
                                              : "first_rotation",
                       "not of a rigid rod, whose joint stays where it is");
  if (supports.first_motion && !hold_of(supports.first).position)
    table.refuse_value("first_motion", "moves an end that is held; supports.first is free");
  if (supports.last_motion && !hold_of(supports.last).position)
    table.refuse_value("last_motion", "moves an end that is held; supports.last is free");
  if (!supports.first_rotation) return;
  if (!hold_of(supports.first).direction)
    table.refuse_value("first_rotation", "turns an end that is clamped; supports.first is another");
  if (hold_of(supports.last).direction)
    table.refuse_value(
        "first_rotation",
        "is computed in a frame that turns with the first end, in which a clamp of the last one "
        "would turn; supports.last must not be clamped");
}

/// The first time in the run at which the first number jumps, of which the second is the rate; -1: none.
double time_of_jump(double end, const std::function<std::pair<double, double>(double)>& at) {
  constexpr int parts = 1000, halvings = 30;
  constexpr double error = 1e-6;  // of the greatest number
  double greatest = 0;
  for (int i = 0; i <= parts; ++i) greatest = std::max(greatest, std::abs(at(end * i / parts).first));
  // What Simpson's rule makes of the rate and what the number does instead.
  const auto gap = [&](double a, double b) {
    const auto first = at(a), middle = at(0.5 * (a + b)), last = at(b);
    return std::abs(last.first - first.first -
                    (b - a) / 6 * (first.second + 4 * middle.second + last.second));
  };
  for (int i = 0; i < parts; ++i) {
    double a = end * i / parts, b = end * (i + 1) / parts;
    for (int k = 0; gap(a, b) > error * greatest; ++k) {
      if (k == halvings) return a;
      const double middle = 0.5 * (a + b);
      (gap(a, middle) > gap(middle, b) ? b : a) = middle;
    }
  }
  return -1;
}

/// Refuses an expression that is not 0 at the start, or is not finite or jumps in value or rate in the run.
void check_in_run(const TableReader& table, std::string_view key, const std::string& expression,
                  const Case& spec) {
  constexpr int times = 1000;
  const TimeFunction function(expression, spec.parameters);
  for (int i = 0; i <= times; ++i) {
    const double t = spec.time.end * i / times;
    const Jet jet = function.jet(t);
    for (const auto& [what, value] :
         {std::pair{"", jet.value}, {"its rate ", jet.rate}, {"its second derivative ", jet.second}})
      if (!std::isfinite(value))
        table.refuse_value(
            key, fmt::format("{}is {} at t = {:.6g} s; must be finite", what, number_text(value), t));
  }
  if (const double first = function(0); first != 0)
    table.refuse_value(
        key, fmt::format("is {} at t = 0; must be 0, as it is counted from the start", number_text(first)));
  const auto refuse_jump = [&](const char* what, double t) {
    if (t >= 0) table.refuse_value(key, fmt::format("{}jumps at t = {:.6g} s; must not", what, t));
  };
  const auto jet = [&](double t) { return function.jet(t); };
  refuse_jump("", time_of_jump(spec.time.end, [&](double t) {
                return std::pair{jet(t).value, jet(t).rate};
              }));
  refuse_jump("its rate ", time_of_jump(spec.time.end, [&](double t) {
                return std::pair{jet(t).rate, jet(t).second};
              }));
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

  make_unit(table, "direction", start.direction);
  return start;
}

SupportsSpec read_supports(TableReader table, CableModel model, const Parameters& parameters) {
  SupportsSpec supports;
  table.read(supports);
  table.finish();
  visit_in_time(supports, [&](const char* name, std::string_view key, const std::string&) {
    if (const TomlValue* written = table.value().find(name)->find(key))
      parameters.check_in_time(*written, fmt::format("{}.{}", table.full_key(name), key));
  });
  if (supports.first_rotation)
    make_unit(table.table("first_rotation"), "axis", supports.first_rotation->axis);
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
  check_moved(table, supports, model);
  return supports;
}

void check_motion(TableReader table, const Case& spec) {
  visit_in_time(spec.supports, [&](const char* name, std::string_view key, const std::string& expression) {
    check_in_run(table.table(name), key, expression, spec);
  });
  const MethodInfo* info = find_method(spec.method.name);
  if (info == nullptr || !spec.supports.first_rotation || info->takes_rotation) return;
  std::string others;
  for (const MethodInfo& other : method_infos())
    if (other.takes_rotation && !other.timeless) others += (others.empty() ? "" : ", ") + other.name;
  table.refuse_value(
      "first_rotation",
      fmt::format("is not taken by {}, as forces in a frame that turns depend on rates and have "
                  "no potential; methods that take it: {}",
                  info->name, others));
}

}  // namespace plumb
