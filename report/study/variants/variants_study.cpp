#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/study/variants/variants_file.h"
#include "report/study/made_study.h"
#include "report/study/variants/variants_figures.h"
#include "report/study/variants/variants_results.h"

namespace plumb {

extern const std::string_view variants_schema_json;

namespace {

class MadeVariants : public MadeStudy {
 public:
  explicit MadeVariants(VariantsStudy study) : study_(std::move(study)) {}

  std::string title() const override { return study_.result.title; }
  std::pair<std::string, std::string> file() const override {
    return {study_json_name, encode_variants(study_)};
  }
  std::vector<Figure> figures() const override { return variants_figures(study_.result); }
  StudyReport report(const Stages& stages) const override { return evaluate_variants(study_, stages); }
  StudySection section(const std::vector<Picture>& pictures) const override {
    return shown_variants(study_.result, pictures);
  }
  std::vector<Finding> findings() const override {
    std::vector<Finding> lines;
    for (const VariantResult& variant : study_.result.variants) {
      using Mood = Finding::Mood;
      const bool expects = variant.spec.expects_anything();
      const char* status = !expects ? "shown" : variant.met() ? "passed" : "failed";
      lines.push_back({fmt::format(" {}: {}", variant.spec.name, found_in_words(variant)),
                       fmt::format("  {:<7}", status),
                       !expects        ? Mood::faint
                       : variant.met() ? Mood::good
                                       : Mood::bad});
      if (expects && !variant.met())
        lines.push_back({fmt::format("          expected: {}", expected_in_words(variant))});
      if (!variant.trajectory.message.empty()) lines.push_back({"          " + variant.trajectory.message});
    }
    return lines;
  }
  bool says_verdicts() const override { return false; }

 private:
  VariantsStudy study_;
};

std::vector<EstimatedPart> variants_parts(const Case& spec, const RunSize& run) {
  const auto variants = static_cast<double>(spec.variants.size());
  return {{Resource::memory, "",
           fmt::format("{:.0f} variants × {:.0f} outputs × {:.0f} nodes", variants, run.outputs,
                       run.elements + 1),
           "study.variant, cable.elements, time.output_interval", variants * run.states()},
          {Resource::time, "", fmt::format("{:.0f} variants", variants), "study.variant",
           variants * run.seconds}};
}

}  // namespace

StudyKind variants_study() {
  return {"variants",
          "_variants",
          [](const Case& spec) { return !spec.variants.empty(); },
          false,
          variants_parts,
          variants_schema_json,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            if (loaded.spec.variants.empty())
              throw InputError(loaded.source.file.name + ": has no [[study.variant]] to run");
            return std::make_unique<MadeVariants>(run_variants(loaded, runner));
          },
          [](const std::string& json, const std::string&) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeVariants>(decode_variants(json));
          }};
}

}  // namespace plumb
