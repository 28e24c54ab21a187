#include "report/study/work_precision/work_precision_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/study/work_precision/cheapest.h"
#include "engine/study/work_precision/run_work_precision.h"
#include "engine/study/work_precision/work_precision_file.h"
#include "report/study/made_study.h"
#include "report/study/work_precision/work_precision_figures.h"
#include "report/study/work_precision/work_precision_page.h"
#include "report/study/work_precision/work_precision_results.h"

namespace plumb {

extern const std::string_view work_precision_schema_json;

namespace {

void add_cheapest(const std::string& title, const std::vector<CheapestRun>& cheapest,
                  std::vector<Finding>& lines) {
  if (cheapest.empty()) return;
  lines.push_back({title});
  for (const CheapestRun& run : cheapest) lines.push_back({"  " + run.in_words});
}

/// The width of the longest label, in characters.
std::size_t label_width(const WorkPrecision& study) {
  std::size_t width = 0;
  for (const MethodCurve& curve : study.curves)
    width = std::max(
        width, static_cast<std::size_t>(std::count_if(curve.label.begin(), curve.label.end(), [](char c) {
          return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
        })));
  return width;
}

void add_orders(const WorkPrecision& study, std::vector<Finding>& lines) {
  const std::size_t width = label_width(study);
  lines.push_back({fmt::format("Observed orders, {}: stated, seen, over which steps",
                               counted(study.fixed_elements, "element", "elements"))});
  for (const MethodCurve& curve : study.curves) {
    if (curve.elements != study.fixed_elements) continue;
    std::string seen = "no asymptotic part of three runs";
    if (curve.observed.order >= 0)
      seen = fmt::format("{:.2f} ± {:.2f}, {:.2g} to {:.2g} s", curve.observed.order,
                         curve.observed.deviation, curve.observed.largest_step, curve.observed.smallest_step);
    lines.push_back({fmt::format("  {:<{}}  {:<8}{}", curve.label, width, curve.stated_order, seen)});
  }
}

void add_front(const WorkPrecision& study, std::vector<Finding>& lines) {
  if (study.time_front.empty()) return;
  lines.push_back({fmt::format("Pareto front, {}: no run is both cheaper and nearer",
                               counted(study.fixed_elements, "element", "elements"))});
  for (const std::size_t k : study.time_front) {
    const auto curve = std::find_if(study.curves.begin(), study.curves.end(), [&](const MethodCurve& any) {
      return std::find(any.runs.begin(), any.runs.end(), k) != any.runs.end();
    });
    lines.push_back({fmt::format("  {:<{}}  {:<20}{:>10}   {:.2g} m", curve->label, label_width(study),
                                 study.runs[k].setting(), study.work_in_words(study.work(study.runs[k])),
                                 study.runs[k].time_error.tip_max)});
  }
}

void add_references(const WorkPrecision& study, std::vector<Finding>& lines) {
  if (study.mesh && study.mesh->observed_order >= 0)
    lines.push_back({fmt::format(
        "Mesh: order {:.2f}; {} elements are some {:.2g} m off, grid convergence index {:.2g} m ({})",
        study.mesh->observed_order, study.mesh->elements.back(), study.mesh->extrapolated_error,
        study.mesh->grid_convergence_index, study.mesh->standard)});
  for (const CommonFloor& floor : study.common_floors) {
    std::string names;
    for (const std::size_t curve : floor.curves)
      names += (names.empty() ? "" : "; ") + study.curves[curve].label;
    lines.push_back({fmt::format("Curves that flatten together at {:.2g} m, which is suspicious: {}",
                                 floor.error, names)});
  }
}

class MadeWorkPrecision : public MadeStudy {
 public:
  explicit MadeWorkPrecision(Study study) : study_(std::move(study)) {}

  std::string title() const override { return study_.result.title; }
  std::pair<std::string, std::string> file() const override {
    return {study_file_name, encode_study(study_)};
  }
  std::vector<Figure> figures() const override { return study_figures(study_.result); }
  StudyReport report(const Stages& stages) const override { return evaluate_study(study_, stages); }
  StudySection section(const std::vector<Picture>& pictures) const override {
    return shown_work_precision(study_.result, pictures);
  }
  std::vector<Finding> findings() const override {
    const WorkPrecision& study = study_.result;
    std::vector<Finding> lines;
    add_orders(study, lines);
    add_front(study, lines);
    add_cheapest(
        fmt::format("Cheapest time integration of {}", counted(study.fixed_elements, "element", "elements")),
        study.time_cheapest, lines);
    add_cheapest("Cheapest method and mesh against the converged solution", study.total_cheapest, lines);
    add_references(study, lines);
    if (!study.given_curves.empty()) lines.push_back({"Other programs"});
    for (const std::string& line : given_points_in_words(study)) lines.push_back({"  " + line});
    return lines;
  }

 private:
  Study study_;
};

std::vector<EstimatedPart> parts_of_all(const Case& spec, const RunSize& run) {
  return work_precision_parts(work_precision_of(spec).full, run);
}

}  // namespace

std::unique_ptr<MadeStudy> made_study(Study study) {
  return std::make_unique<MadeWorkPrecision>(std::move(study));
}

StudyKind work_precision_study() {
  return {"work-precision",
          "_study",
          [](const Case& spec) { return spec.work_precision.has_value(); },
          false,
          parts_of_all,
          work_precision_schema_json,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            return made_study({loaded, run_work_precision(loaded.spec, false, runner, loaded.given_runs)});
          },
          nullptr};
}

}  // namespace plumb
