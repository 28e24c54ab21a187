#include "engine/run/probes_json.h"

#include <stdexcept>

#include "engine/base/codec.h"
#include "engine/run/stored_parts.h"

namespace plumb {
nlohmann::ordered_json to_stored(const std::vector<Energies>& energies) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : stored_energies()) {
    std::vector<double> values;
    for (const Energies& any : energies) values.push_back(any.*value);
    json[name] = encode(values);
  }
  return json;
}

void from_stored(const nlohmann::ordered_json& json, std::vector<Energies>& energies) {
  energies.assign(json.at(stored_energies().front().first).size(), {});
  for (const auto& [name, value] : stored_energies()) {
    // Studies of older versions have their totals at outputs.
    if (!is_stored_always(value) && !json.contains(name)) continue;
    const auto values = decoded<std::vector<double>>(json.at(name));
    if (values.size() != energies.size()) throw std::runtime_error("its energies are not one an output");
    for (std::size_t k = 0; k < values.size(); ++k) energies[k].*value = values[k];
  }
}

}  // namespace plumb
