#include "engine/study/variants/variants_file.h"

#include <stdexcept>

#include "engine/base/parse_json.h"
#include "engine/study/study_record.h"
#include "engine/study/variants/variants_members.h"

namespace plumb {
namespace {

// Version 1 had null for all that is not finite, and is no longer read.
constexpr int variants_file_version = 2;

void complete(VariantResult& variant, const VariantSpec& spec, const CaseSource& source) {
  if (variant.spec.name != spec.name) throw std::runtime_error("its variants are not those of its case");
  variant.spec = spec;
  variant.run = load_variant(source, spec).spec;
  const std::vector<double>& times = variant.trajectory.times;
  variant.probes.times = times;
  if (variant.trajectory.energies.size() != times.size())
    throw std::runtime_error("its energies are not one an output");
  for (const Column& column : variant.probes.columns)
    if (column.values.size() != times.size()) throw std::runtime_error("its probes are not one an output");
  if (variant.expectations.size() != spec.expectations.size())
    throw std::runtime_error("its figures are not those of its case");
  for (std::size_t k = 0; k < spec.expectations.size(); ++k)
    variant.expectations[k].expected = spec.expectations[k];
}

}  // namespace

std::string encode_variants(const VariantsStudy& study) {
  return encode_study_record(
      "variants", variants_file_version, study.loaded.source,
      {{"variants", encode(study.result.variants)}, {"provenance", encode(study.result.provenance)}});
}

VariantsStudy decode_variants(const std::string& text) {
  constexpr const char* file = "study.json";
  StudyRecord record =
      decode_study_record(text, file, "variants", variants_file_version, variants_file_version);
  try {
    VariantsStudy study{std::move(record.loaded), {}};
    study.result.title = study.loaded.spec.title;
    const std::vector<VariantSpec>& specs = study.loaded.spec.variants;
    decode(record.body.at("variants"), study.result.variants);
    if (study.result.variants.size() != specs.size())
      throw std::runtime_error("its variants are not those of its case");
    for (std::size_t k = 0; k < specs.size(); ++k)
      complete(study.result.variants[k], specs[k], study.loaded.source);
    decode(record.body.at("provenance"), study.result.provenance);
    return study;
  } catch (...) {
    refuse_unusable(file);
  }
}

}  // namespace plumb
