#pragma once

#include <nlohmann/json_fwd.hpp>

namespace plumb {

/// The result of a verb on standard output. Bytes that are no UTF-8 (in a file name, say) become the
/// replacement character. Throws OutputError.
void print_json(const nlohmann::ordered_json& json);

}  // namespace plumb
