#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/integrate/method_info.h"
#include "report/document/case_json.h"
#include "report/program/limits.h"
#include "report/program/print_json.h"
#include "report/program/run_pipeline.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

ExitStatus do_check(const Options& options, Console& console) {
  const LoadedCase loaded = load(options, console);
  const Case& spec = loaded.spec;
  const bool reports_given = reports_given_run(spec);
  long criteria = 0;
  for (const ReferenceUse& use : spec.references) criteria += std::ssize(use.compare);
  criteria *= std::ssize(spec.given_runs) + (reports_given ? 0 : 1);
  for (const GivenRunSpec& given : spec.given_runs) criteria += std::ssize(given.tolerances);
  const std::string what =
      reports_given ? "an external run"
                    : counted(spec.cable.elements, "element", "elements") + ", " + spec.method.name;
  const MethodInfo* info = find_method(spec.method.name);
  const std::string until =
      info != nullptr && info->timeless ? "" : fmt::format(" to {:.4g} s", spec.time.end);
  console.line(fmt::format("{} is valid: {}, {}{}, {}", loaded.source.file.name, spec.title, what, until,
                           counted(criteria, "criterion", "criteria")));
  for (std::size_t k = 0; k < spec.given_runs.size(); ++k) {
    const GivenRun& given = loaded.given_runs[k];
    console.line(fmt::format("{}: {} of {}, {}, {} from {:.4g} to {:.4g} s", spec.given_runs[k].name,
                             counted(std::ssize(given.columns), "column", "columns"),
                             computed_by(spec.given_runs[k]), given.taken_for,
                             counted(std::ssize(given.times), "row", "rows"), given.times.front(),
                             given.times.back()));
  }
  const Estimate made = check_estimate(spec, work_of_run(spec), loaded.source.file.name,
                                       output_path(options, loaded), options, console);
  remark_on_inputs(spec, console);
  console.line("plumb run of it would take");
  for (const std::string& line : in_words(made)) console.line("  " + line);
  if (options.json) print_json(case_json(loaded));
  return ExitStatus::done;
}

}  // namespace

Verb check_verb() {
  return {.name = "check",
          .summary = "say whether a case is valid, without running it",
          .act = do_check,
          .input = "CASE",
          .takes_overrides = true,
          .is_estimated = true};
}

}  // namespace plumb
