#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"
#include "engine/read/table_reader.h"
#include "engine/read/toml_value.h"

namespace plumb {

/// Those of [cable] that mean nothing to a model.
std::vector<std::string_view> foreign_keys(CableModel model);

/// Where an override has made the cable a chain or a rigid rod, takes the keys of the file's [cable] that
/// these do not have out of `merged`. Returns a remark each.
std::vector<std::string> drop_keys_of_other_models(TomlValue& merged);

/// Refuses an imperfection that is beyond a tenth of the length, or that has no buckling mode to be in.
/// Throws InputError.
void check_imperfection(const Case& spec, const TableReader& start);

/// The tables of a case that say what a rigid rod may not be given.
struct RigidTables {
  const TableReader& start;
  const TableReader& method;
  const std::vector<TableReader>& probes;
};

/// Refuses what a rigid rod has not: another method than rigid_rod_method(), slopes that do not turn with it,
/// a speed along it, strains and curvatures. Throws InputError.
void check_rigid(const Case& spec, const RigidTables& tables);

}  // namespace plumb
