#include <fmt/format.h>

#include <set>

#include "engine/case/name_rule.h"
#include "engine/read/case_sections.h"

namespace plumb {

std::vector<ProbeSpec> read_probes(std::vector<TableReader> tables) {
  std::vector<ProbeSpec> probes;
  std::set<std::string> names;
  for (TableReader& table : tables) {
    ProbeSpec probe;
    table.read(probe);
    table.finish();

    if (!follows_name_rule(probe.name)) table.refuse_value("name", fmt::format("must be {}", name_rule));
    if (probe.name == "t") table.refuse_value("name", "is the name of the time");
    if (!names.insert(probe.name).second) table.refuse_value("name", "is the name of another probe");
    probes.push_back(probe);
  }
  return probes;
}

}  // namespace plumb
