#include <fmt/format.h>

#include "engine/study/stability/run_stability.h"
#include "report/study/made_study.h"
#include "report/study/stability/stability_figures.h"
#include "report/study/stability/stability_results.h"

namespace plumb {
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

}  // namespace

StudyKind stability_study();

StudyKind stability_study() {
  return {stability_kind,
          "_stability",
          [](const Case& spec) { return spec.stability.has_value(); },
          false,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeStability>(StabilityStudyFile{loaded, run_stability(loaded, runner)});
          },
          [](const std::string& json, const std::string& file) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeStability>(decode_stability(json, file));
          }};
}

}  // namespace plumb
