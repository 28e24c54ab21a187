#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/case_json.h"
#include "report/program/print_json.h"
#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus check_verb(const Options& options, Talk& talk) {
  const LoadedCase loaded = load(options, talk);
  long criteria = 0;
  for (const ReferenceUse& use : loaded.spec.references) criteria += std::ssize(use.compare);
  talk.line(fmt::format("{} is valid: {}, {}, {} to {:.4g} s, {}", loaded.source.file.name, loaded.spec.title,
                        counted(loaded.spec.cable.elements, "element", "elements"), loaded.spec.method.name,
                        loaded.spec.time.end, counted(criteria, "criterion", "criteria")));
  if (options.json) print_json(case_json(loaded));
  return ExitStatus::done;
}

}  // namespace plumb
