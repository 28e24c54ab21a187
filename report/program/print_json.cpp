#include "report/program/print_json.h"

#include <nlohmann/json.hpp>

#include "engine/base/file_writing.h"

namespace plumb {

void print_json(const nlohmann::ordered_json& json) {
  write_to_standard_output(json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace plumb
