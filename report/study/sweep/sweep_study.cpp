#include <fmt/format.h>

#include "engine/study/sweep/run_sweep.h"
#include "engine/study/sweep/sweep_json.h"
#include "report/study/made_study.h"
#include "report/study/sweep/sweep_results.h"

namespace plumb {

extern const std::string_view sweep_schema_json;

namespace {

class MadeSweep : public MadeStudy {
 public:
  explicit MadeSweep(Sweep sweep) : sweep_(std::move(sweep)) {}

  std::string title() const override { return sweep_.loaded.spec.title; }
  std::pair<std::string, std::string> file() const override {
    return {study_json_name, encode_sweep(sweep_)};
  }
  std::vector<Figure> figures() const override { return sweep_figures(sweep_); }
  StudyReport report(const Stages& stages) const override { return evaluate_sweep(sweep_, stages); }
  StudySection section(const std::vector<Picture>& pictures) const override {
    return shown_sweep(sweep_, pictures);
  }
  std::vector<Finding> findings() const override {
    std::vector<Finding> lines;
    for (const std::string& line : outcome_lines(sweep_)) lines.push_back({line});
    for (const SweepRun& run : sweep_.runs)
      if (const std::string trouble = trouble_of(run, sweep_.spec.tolerance); !trouble.empty())
        lines.push_back({fmt::format(": {}: {}", trouble, command_of(sweep_, run)),
                         fmt::format("case {}", run.number), Finding::Mood::bad});
    return lines;
  }

 private:
  Sweep sweep_;
};

std::vector<EstimatedPart> sweep_parts(const Case& spec, const RunSize&) {
  const SweepSpec sweep = sweep_of(spec);
  const std::string cases = fmt::format("{} cases", sweep.cases);
  return {{Resource::memory, "", cases, "study.sweep.cases", 4e3 * sweep.cases},
          {Resource::disk, "", cases, "study.sweep.cases", 2e3 * sweep.cases},
          {Resource::time, "", fmt::format("at most {} × {:g} s", cases, sweep.time_limit),
           "study.sweep: cases, time_limit", sweep.cases * sweep.time_limit}};
}

}  // namespace

StudyKind sweep_study() {
  return {"sweep",
          "_sweep",
          [](const Case& spec) { return spec.sweep.has_value(); },
          false,
          sweep_parts,
          sweep_schema_json,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeSweep>(run_sweep(loaded, runner));
          },
          [](const std::string& json, const std::string& file) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeSweep>(decode_sweep(json, file));
          }};
}

}  // namespace plumb
