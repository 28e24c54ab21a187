#include "report/library/plumb.h"

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/run/mode_table.h"
#include "engine/run/run.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

std::vector<std::vector<double>> as_numbers(const std::vector<Eigen::VectorXd>& vectors) {
  std::vector<std::vector<double>> result;
  result.reserve(vectors.size());
  for (const Eigen::VectorXd& vector : vectors) result.emplace_back(vector.begin(), vector.end());
  return result;
}

/// A name stands for a reference or an external run alike.
CaseSource source_of(const CaseText& text) {
  CaseSource source{{"case", text.toml}, text.overrides, {}};
  for (const auto& [name, content] : text.files) source.references.push_back({name, content});
  return source;
}

}  // namespace

CaseRun run_case(const CaseText& text) {
  Run run{load_case(source_of(text)), {}, {}, provenance_now()};
  if (reports_given_run(run.loaded.spec))
    throw InputError("case: has no [method], so there is nothing to solve");
  if (run.loaded.spec.method.name == scene_method)
    throw InputError(
        "case: method.name = \"scene\": leaves the method to pictures, which are not drawn here");
  run.trajectory = integrate(run.loaded.spec);
  run.probes = probe(run.loaded.spec, run.trajectory);
  run.modes = mode_table(run.loaded.spec, run.trajectory);
  const Results results = evaluate(run, {});

  CaseRun result;
  result.outcome = word(results.outcome);
  result.message = run.trajectory.message;
  result.times = run.trajectory.times;
  result.q = as_numbers(run.trajectory.q);
  result.v = as_numbers(run.trajectory.v);
  for (const Column& column : run.probes.columns)
    result.probes.push_back({column.name, column.unit, column.values});
  for (const Verdict& verdict : results.verdicts)
    result.verdicts.push_back({verdict.name, std::string(word(verdict.kind)),
                               std::string(word(verdict.status)), verdict.value, verdict.limit, verdict.unit,
                               verdict.message});
  result.all_met = all_met(results.verdicts);
  result.steps = run.trajectory.counters.steps;
  result.relative_energy_drift = run.trajectory.relative_energy_drift();
  return result;
}

}  // namespace plumb
