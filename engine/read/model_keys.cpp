#include "engine/read/model_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/method_roles.h"
#include "engine/model/buckling.h"
#include "engine/model/cable.h"

namespace plumb {

std::vector<std::string_view> foreign_keys(CableModel model) {
  std::vector<std::string_view> names;
  for (const Key& key : keys_of<CableSpec>())
    if (model == CableModel::chain ? key.not_of_chain : model == CableModel::rigid && key.not_of_rigid)
      names.push_back(key.name);
  return names;
}

std::vector<std::string> drop_keys_of_other_models(TomlValue& merged) {
  TomlValue* cable = merged.find("cable");
  if (cable == nullptr || cable->kind != TomlValue::Kind::table) return {};
  const TomlValue* model = cable->find("model");
  if (model == nullptr || !model->place.in_override()) return {};
  std::vector<std::string_view> foreign;
  for (const auto& known : words_of<CableModel>)
    if (known.word == model->string) foreign = foreign_keys(known.value);
  const std::string name = model->string;
  std::vector<std::string> remarks;
  std::erase_if(cable->items, [&](const TomlValue& item) {
    if (item.place.in_override() || std::find(foreign.begin(), foreign.end(), item.key) == foreign.end())
      return false;
    remarks.push_back(
        fmt::format("cable.{} = {} of the file is not used by the model {}", item.key, item.written, name));
    return true;
  });
  return remarks;
}

void check_imperfection(const Case& spec, const TableReader& start) {
  constexpr double largest = 0.1;  // of the length: a mode is that of small displacements
  constexpr std::string_view key = "imperfection";
  if (!(std::abs(spec.start.imperfection) <= largest * spec.cable.length))
    start.refuse_value(key, fmt::format("must be at most a tenth of the length, {:g} m, to either side",
                                        largest * spec.cable.length));
  if (spec.cable.model != CableModel::cable)
    start.refuse_value(
        key, fmt::format("must be 0 for the model {}, which does not bend", word(spec.cable.model)));
  StartSpec straight = spec.start;
  straight.imperfection = 0;
  const Cable cable(spec);
  if (!first_buckling(cable, cable.start_q(straight)))
    start.refuse_value(key,
                       fmt::format("there is no buckling mode for it to be in: up to {:g} times these loads "
                                   "nothing presses this cable, held as it is, so that it gives way",
                                   greatest_buckling_load));
}

void check_rigid(const Case& spec, const RigidTables& tables) {
  const std::string& method = spec.method.name;  // empty: an external run is reported
  if (!method.empty() && method != rigid_rod_method().name && method != scene_method)
    tables.method.refuse_value(
        "name", fmt::format("must be \"{}\" for a rigid rod, which has no elements for other methods",
                            rigid_rod_method().name));
  if (spec.start.slope_rates != SlopeRates::rigid)
    tables.start.refuse_value("slope_rates", "must be \"rigid\" for a rigid rod, whose slopes turn with it");
  if (spec.start.axial_speed != 0)
    tables.start.refuse_value("axial_speed", "must be 0 for a rigid rod, which does not stretch");
  if (spec.start.stretch != 1)
    tables.start.refuse_value("stretch", "must be 1 for a rigid rod, which does not stretch");
  for (std::size_t k = 0; k < spec.probes.size(); ++k)
    if (!is_vector(spec.probes[k].quantity))
      tables.probes[k].refuse_value("quantity", "a rigid rod has only position, velocity and slope");
}

}  // namespace plumb
