#include "engine/study/variants/run_variants.h"

#include <mutex>

#include "engine/base/parallel.h"
#include "engine/integrate/integrate.h"
#include "engine/study/variants/variant_figure.h"

namespace plumb {

VariantsStudy run_variants(const LoadedCase& loaded, const VariantsProgress& progress) {
  VariantsStudy study{loaded, {loaded.spec.title, {}, provenance_now()}};
  std::vector<VariantResult>& all = study.result.variants;
  all.resize(loaded.spec.variants.size());
  std::mutex guard;
  std::size_t done = 0;
  for_each_in_parallel(all.size(), [&](std::size_t k) {
    VariantResult& variant = all[k];
    variant.spec = loaded.spec.variants[k];
    variant.run = load_variant(loaded.source, variant.spec).spec;
    variant.trajectory = integrate(variant.run);
    variant.probes = probe(variant.run, variant.trajectory);
    const std::lock_guard lock(guard);
    ++done;
    if (progress) progress(variant.spec.name, static_cast<double>(done) / static_cast<double>(all.size()));
  });
  for (VariantResult& variant : all)
    for (const ExpectationSpec& expected : variant.spec.expectations)
      variant.expectations.push_back(find_figure(expected, variant, all));
  for (VariantResult& variant : all) {
    variant.trajectory.q.clear();
    variant.trajectory.v.clear();
    variant.trajectory.multipliers.clear();
  }
  return study;
}

}  // namespace plumb
