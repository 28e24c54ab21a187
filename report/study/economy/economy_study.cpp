#include <fmt/format.h>

#include "engine/study/economy/economy_study_json.h"
#include "engine/study/economy/run_economy.h"
#include "report/study/economy/economy_gauge.h"
#include "report/study/economy/economy_results.h"
#include "report/study/made_study.h"

namespace plumb {

extern const std::string_view economy_schema_json;

namespace {

class MadeEconomy : public MadeStudy {
 public:
  explicit MadeEconomy(EconomyStudy study) : study_(std::move(study)) {}

  std::string title() const override { return study_.loaded.spec.title; }
  std::pair<std::string, std::string> file() const override {
    return {study_json_name, encode_economy_study(study_)};
  }
  std::vector<Figure> figures() const override { return economy_study_figures(study_); }
  StudyReport report(const Stages& stages) const override { return evaluate_economy(study_, stages); }
  StudySection section(const std::vector<Picture>& pictures) const override {
    return shown_economy(study_, pictures);
  }
  std::vector<Finding> findings() const override {
    std::vector<Finding> lines;
    for (const std::string& line : need_lines(study_)) lines.push_back({line});
    return lines;
  }

 private:
  EconomyStudy study_;
};

std::vector<EstimatedPart> economy_parts(const Case& spec, const RunSize& run) {
  constexpr double seconds_a_scene = 2;
  const EconomySpec economy = economy_study_of(spec);
  const double scenes = economy.scenes + static_cast<double>(economy.widths.size());
  return {{Resource::memory, "",
           fmt::format("{:.0f} scenes, references of {} elements", scenes, economy.reference_elements),
           "study.economy: scenes, reference_elements",
           8e3 * scenes + 4 * run.states(2.0 * economy.reference_elements)},
          {Resource::time, "", fmt::format("{:.0f} scenes", scenes), "study.economy.scenes",
           seconds_a_scene * scenes}};
}

}  // namespace

StudyKind economy_study() {
  return {economy_kind,
          "_economy",
          [](const Case& spec) { return spec.economy.has_value(); },
          true,
          economy_parts,
          economy_schema_json,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeEconomy>(run_economy(loaded, gauge_maker, runner));
          },
          [](const std::string& json, const std::string& file) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeEconomy>(decode_economy_study(json, file));
          }};
}

}  // namespace plumb
