#include "engine/study/variants/run_variants.h"

#include <algorithm>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/study/variants/variant_figure.h"
#include "engine/study/variants/variants_members.h"

namespace plumb {
namespace {

/// Whether the distance of a variant to another, or of another to it, is a figure.
bool needs_states(const VariantSpec& variant, const std::vector<VariantSpec>& all) {
  const auto has_distance = [](const VariantSpec& spec, const std::string& to) {
    return std::any_of(spec.expectations.begin(), spec.expectations.end(),
                       [&](const ExpectationSpec& figure) {
                         return figure.quantity == "distance" && (to.empty() || figure.from == to);
                       });
  };
  return has_distance(variant, "") || std::any_of(all.begin(), all.end(), [&](const VariantSpec& other) {
           return has_distance(other, variant.name);
         });
}

}  // namespace

VariantsStudy run_variants(const LoadedCase& loaded, Runner& runner) {
  VariantsStudy study{loaded, {loaded.spec.title, {}, {}}};
  const std::vector<VariantSpec>& specs = loaded.spec.variants;
  std::vector<Case> cases;
  for (const VariantSpec& spec : specs) cases.push_back(load_variant(loaded.source, spec).spec);
  std::vector<Trajectory> trajectories(specs.size());
  std::vector<StudyPoint<VariantResult>> points;
  for (std::size_t k = 0; k < specs.size(); ++k)
    points.push_back({specs[k].name, [&, k] {
                        VariantResult variant;
                        variant.spec = specs[k];
                        variant.trajectory = integrate(cases[k]);
                        variant.probes = probe(cases[k], variant.trajectory);
                        trajectories[k] = variant.trajectory;
                        return variant;
                      }});
  std::vector<VariantResult>& all = study.result.variants;
  all = runner.run("runs", points);
  runner.conclude();
  study.result.provenance = runner.provenance();
  for_each_in_parallel(all.size(), [&](std::size_t k) {
    VariantResult& variant = all[k];
    variant.spec = specs[k];
    variant.run = cases[k];
    variant.probes.times = variant.trajectory.times;
    if (!needs_states(specs[k], specs)) return;
    // Those of a run that the journal had are made again.
    if (trajectories[k].outcome == Outcome::not_run) trajectories[k] = integrate(cases[k]);
    variant.trajectory.q = std::move(trajectories[k].q);
  });
  for (VariantResult& variant : all)
    for (const ExpectationSpec& expected : variant.spec.expectations)
      variant.expectations.push_back(find_figure(expected, variant, all));
  for (VariantResult& variant : all) variant.trajectory.q.clear();
  return study;
}

}  // namespace plumb
