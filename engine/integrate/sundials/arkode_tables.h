#pragma once

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <memory>

namespace plumb {

struct FreeTable {
  void operator()(ARKodeButcherTable table) const { ARKodeButcherTable_Free(table); }
};
/// The library's Butcher table, owned.
using ArkodeTable = std::unique_ptr<ARKodeButcherTableMem, FreeTable>;

/// The pair of `arkode-erk` that advances with a formula of that order, 2 to 8. Throws std::bad_alloc.
ArkodeTable explicit_table(int order);

/// The pair of `arkode-dirk` of that order, 2 to 5, by the library's number for it and in full. The latter
/// throws std::bad_alloc.
ARKODE_DIRKTableID implicit_table_of(int order);
ArkodeTable implicit_table(int order);

/// What a step by the table does to a vibration with ωh = z (MethodInfo::amplification).
double amplification(const ArkodeTable& table, double z);

}  // namespace plumb
