#include <fmt/format.h>

#include "engine/read/case_sections.h"
#include "engine/study/stability/run_stability.h"
#include "report/study/made_study.h"
#include "report/study/stability/stability_figures.h"
#include "report/study/stability/stability_results.h"

namespace plumb {

extern const std::string_view stability_schema_json;

namespace {

class MadeStability : public MadeStudy {
 public:
  explicit MadeStability(StabilityStudyFile study) : study_(std::move(study)) {}

  std::string title() const override { return study_.result.title; }
  std::pair<std::string, std::string> file() const override {
    return {study_json_name, encode_stability(study_)};
  }
  std::vector<Figure> figures() const override { return stability_figures(study_.result); }
  std::vector<Figure> figures_beside() const override { return method_figures(study_.result); }
  StudyReport report(const Stages& stages) const override { return evaluate_stability(study_, stages); }
  StudySection section(const std::vector<Picture>& pictures) const override {
    return shown_stability(study_.result, pictures);
  }
  std::vector<Finding> findings() const override {
    const Stability& study = study_.result;
    const MapAxis axis = study.parameter.empty() ? MapAxis::elements : MapAxis::parameter;
    std::vector<Finding> lines{
        {fmt::format("Steps at {}, to {:g} m", place_in_words(study, MapAxis::duration), study.tolerance)}};
    for (const OutcomeMap& map : study.maps)
      if (map.axis == axis) lines.push_back({fmt::format("  {}: {}", map.label, map.in_words)});
    return lines;
  }

 private:
  StabilityStudyFile study_;
};

std::vector<EstimatedPart> stability_parts(const Case& spec, const RunSize& run) {
  const StabilitySpec s = stability_of(spec);
  const auto columns =
      static_cast<double>(s.parameter_values.size() + s.elements.size() + s.durations.size());
  const double runs = static_cast<double>(s.methods.size()) * s.steps * columns;
  const int finest = s.elements.empty() ? 1 : s.elements.back();
  return {{Resource::memory, "", fmt::format("{:.0f} runs on up to {} elements", runs, finest),
           "study.stability: elements, steps, methods", runs * 500 + 4 * run.states(2.0 * finest)},
          {Resource::time, "", fmt::format("at most {:.0f} runs × {:g} s", runs, s.time_limit),
           "study.stability: methods, steps, elements, parameter_values, durations, time_limit",
           runs * s.time_limit}};
}

}  // namespace

StudyKind stability_study() {
  return {stability_kind,
          "_stability",
          [](const Case& spec) { return spec.stability.has_value(); },
          false,
          stability_parts,
          stability_schema_json,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeStability>(StabilityStudyFile{loaded, run_stability(loaded, runner)});
          },
          [](const std::string& json, const std::string& file) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeStability>(decode_stability(json, file));
          }};
}

}  // namespace plumb
