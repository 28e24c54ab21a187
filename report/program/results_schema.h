#pragma once

#include <string>

namespace plumb {

/// The JSON Schema of results.json: report/results.schema.json with the tables of a case by their keys, and
/// what each kind of study says of its own.
std::string results_schema();

}  // namespace plumb
