#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {

/// tests/data/small_case.toml with its reference, and beside them, for other cases that name them, the
/// references of the shelf and a run "run.csv".
const CaseSource& small_source();

/// A case without [method] on "run.csv".
std::string small_given_case();

/// The texts of the cases of the shelf, without their comments.
std::vector<std::string> shelf_texts();

/// The texts of the references: the small one first, then those of the shelf that are not long.
std::vector<std::string> reference_texts();

}  // namespace plumb::fuzz
