#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "report/case_json.h"
#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus check_verb(const Options& options, Talk& talk) {
  const LoadedCase loaded = load(options, talk);
  std::size_t criteria = 0;
  for (const ReferenceUse& use : loaded.spec.references) criteria += use.compare.size();
  talk.line(fmt::format("{} is valid: {}, {} elements, {} to {:.4g} s, {} criteria", loaded.source.file.name,
                        loaded.spec.title, loaded.spec.cable.elements, loaded.spec.method.name,
                        loaded.spec.time.end, criteria));
  if (options.json) std::fputs((case_json(loaded).dump(1) + "\n").c_str(), stdout);
  return ExitStatus::done;
}

}  // namespace plumb
