#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "engine/base/number_text.h"
#include "engine/base/time_function.h"
#include "engine/integrate/method_info.h"
#include "engine/read/case_sections.h"

namespace plumb {
namespace {

/// Of a moment's size: a part along the cable that is no more is round-off.
constexpr double round_off = 1e-12;

/// Torsion is not modelled, so that nothing turns about the cable's own axis.
void check_moment(const TableReader& table, const LoadSpec& load, const Vec3& direction) {
  if (std::abs(load.value.dot(direction)) > round_off * load.value.norm())
    table.refuse_value(
        "value",
        "a moment must be across the cable at the start: there is no torsion, so that its part "
        "along the cable has nothing to turn");
}

LoadSpec read_load(TableReader& table, CableModel model, const Vec3& direction,
                   const Parameters& parameters) {
  LoadSpec load;
  table.read(load);
  table.finish();
  const bool along = load.kind == LoadKind::distributed, has_place = table.has("at");
  if (along && has_place) table.refuse_value("at", "not a key of a distributed load, which is everywhere");
  if (!along && !has_place)
    table.refuse_value("at", "is missing: where the load acts, from 0 to 1 (fraction of the length)");
  if (load.kind == LoadKind::moment) {
    if (model == CableModel::chain)
      table.refuse_value("kind", "a chain does not bend, so that a moment has nothing to turn");
    check_moment(table, load, direction);
  }
  if (const TomlValue* factor = table.value().find("factor"))
    parameters.check_in_time(*factor, table.full_key("factor"));
  return load;
}

}  // namespace

LoadsSpec read_loads(TableReader table, std::vector<TableReader> applied, CableModel model,
                     const Vec3& direction, const Parameters& parameters) {
  LoadsSpec loads;
  table.read(loads);
  table.finish();
  for (TableReader& load : applied) loads.applied.push_back(read_load(load, model, direction, parameters));
  return loads;
}

void check_factors(const std::vector<TableReader>& applied, const Case& spec) {
  constexpr int times = 1000;
  for (std::size_t k = 0; k < applied.size(); ++k) {
    const TimeFunction factor(spec.loads.applied[k].factor, spec.parameters);
    for (int i = 0; i <= (factor.is_constant() ? 0 : times); ++i) {
      const double t = spec.time.end * i / times;
      if (const double value = factor(t); !std::isfinite(value))
        applied[k].refuse_value("factor",
                                fmt::format("is {} at t = {:.6g} s; must be finite", number_text(value), t));
    }
  }
}

std::vector<MassSpec> read_masses(std::vector<TableReader> tables) {
  std::vector<MassSpec> masses;
  for (TableReader& table : tables) {
    MassSpec mass;
    table.read(mass);
    table.finish();
    masses.push_back(mass);
  }
  return masses;
}

DampingSpec read_damping(TableReader table, CableModel model) {
  DampingSpec damping;
  table.read(damping);
  table.finish();
  if (model == CableModel::rigid && damping.material != 0)
    table.refuse_value("material", "must be 0 for a rigid rod, which does not deform");
  return damping;
}

void check_frame(const TableReader& start, const TableReader& supports, const TableReader& loads,
                 const std::vector<TableReader>& applied, const TableReader& damping, const Case& spec) {
  const MethodInfo& info = *find_method(spec.method.name);
  const Vec3& spin = spec.start.angular_velocity;
  const std::string still = fmt::format("must be 0 for {}, which starts at rest", info.name);
  if (!spin.isZero(0) && !info.spins) start.refuse_value("angular_velocity", still);
  if (spec.start.axial_speed != 0) start.refuse_value("axial_speed", still);
  if (info.timeless && spec.supports.move())
    supports.refuse_value(
        spec.supports.first_motion  ? "first_motion"
        : spec.supports.last_motion ? "last_motion"
                                    : "first_rotation",
        fmt::format("is not taken by {}, which looks for vibrations about a place of rest", info.name));
  if (spin.isZero(0)) return;
  const auto turns = [&](const Vec3& load) {
    return spin.cross(load).norm() > round_off * spin.norm() * load.norm();
  };
  const std::string along = fmt::format(
      "must be along start.angular_velocity for {}: the cable rests in a frame that turns with it, in which "
      "what is across goes round",
      info.name);
  if (turns(spec.loads.gravity)) loads.refuse_value("gravity", along);
  if (turns(spec.loads.end_force)) loads.refuse_value("end_force", along);
  for (std::size_t k = 0; k < applied.size(); ++k)
    if (!spec.loads.applied[k].follows && turns(spec.loads.applied[k].value))
      applied[k].refuse_value("value", along + ", unless the load follows");
  if (spec.damping.mass != 0)
    damping.refuse_value(
        "mass",
        fmt::format("must be 0 for {} in a frame that turns, as it would slow the turning", info.name));
}

void check_damping(const TableReader& table, const Case& spec) {
  const MethodInfo* info = find_method(spec.method.name);
  if (info == nullptr || info->takes_damping || spec.damping == DampingSpec{}) return;
  std::string others;
  for (const MethodInfo& other : method_infos())
    if (other.dynamic && other.takes_damping) others += (others.empty() ? "" : ", ") + other.name;
  const char* key = spec.damping.mass != 0 ? "mass" : "material";
  table.refuse_value(key, fmt::format("must be 0 for {}, which is made for forces that do not depend on "
                                      "rates; methods that take damping: {}",
                                      info->name, others));
}

}  // namespace plumb
