#include "report/program/work_precision_pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/study/work_precision/cheapest.h"
#include "engine/study/work_precision/run_work_precision.h"
#include "report/program/study_end.h"
#include "report/study/work_precision/work_precision_figures.h"
#include "report/study/work_precision/work_precision_page.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* study_file_name = "study.h5";

void say_cheapest(const std::string& title, const std::vector<CheapestRun>& cheapest, Talk& talk) {
  if (cheapest.empty()) return;
  talk.line(title);
  for (const CheapestRun& run : cheapest) talk.line("  " + run.in_words);
}

/// The width of the longest label, in characters.
std::size_t label_width(const WorkPrecision& study) {
  std::size_t width = 0;
  for (const StudyCurve& curve : study.curves)
    width = std::max(
        width, static_cast<std::size_t>(std::count_if(curve.label.begin(), curve.label.end(), [](char c) {
          return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
        })));
  return width;
}

void say_orders(const WorkPrecision& study, Talk& talk) {
  const std::size_t width = label_width(study);
  talk.line(fmt::format("Observed orders, {}: stated, seen, over which steps",
                        counted(study.fixed_elements, "element", "elements")));
  for (const StudyCurve& curve : study.curves) {
    if (curve.elements != study.fixed_elements) continue;
    std::string seen = "no asymptotic part of three runs";
    if (curve.observed.order >= 0)
      seen = fmt::format("{:.2f} ± {:.2f}, {:.2g} to {:.2g} s", curve.observed.order,
                         curve.observed.deviation, curve.observed.largest_step, curve.observed.smallest_step);
    talk.line(fmt::format("  {:<{}}  {:<8}{}", curve.label, width, curve.stated_order, seen));
  }
}

void say_front(const WorkPrecision& study, Talk& talk) {
  if (study.time_front.empty()) return;
  talk.line(fmt::format("Pareto front, {}: no run is both cheaper and nearer",
                        counted(study.fixed_elements, "element", "elements")));
  for (const std::size_t k : study.time_front) {
    const auto curve = std::find_if(study.curves.begin(), study.curves.end(), [&](const StudyCurve& any) {
      return std::find(any.runs.begin(), any.runs.end(), k) != any.runs.end();
    });
    talk.line(fmt::format("  {:<{}}  {:<20}{:>10}   {:.2g} m", curve->label, label_width(study),
                          study.runs[k].setting(), duration_in_words(study.runs[k].work_seconds()),
                          study.runs[k].time_error.tip_max));
  }
}

void say_references(const WorkPrecision& study, Talk& talk) {
  if (study.mesh && study.mesh->observed_order >= 0)
    talk.line(fmt::format(
        "Mesh: order {:.2f}; {} elements are some {:.2g} m off, grid convergence index {:.2g} m ({})",
        study.mesh->observed_order, study.mesh->elements.back(), study.mesh->extrapolated_error,
        study.mesh->grid_convergence_index, study.mesh->standard));
  for (const CommonFloor& floor : study.common_floors) {
    std::string names;
    for (const std::size_t curve : floor.curves)
      names += (names.empty() ? "" : "; ") + study.curves[curve].label;
    talk.line(
        fmt::format("Curves that flatten together at {:.2g} m, which is suspicious: {}", floor.error, names));
  }
}

}  // namespace

Study quick_study(const LoadedCase& loaded, Journal& journal, Talk& talk) {
  Runner runner(journal,
                [&](const std::string& part, double share) { talk.progress("study: " + part, share); });
  Study study{loaded, run_work_precision(loaded.spec, true, runner)};
  talk.end_progress();
  return study;
}

void write_study(const Study& study, OutputFolder& folder) {
  folder.write(study_file_name, encode_study(study));
}

std::optional<Study> study_beside(const std::string& run_path) {
  std::error_code ignored;
  const fs::path folder =
      fs::is_directory(run_path, ignored) ? fs::path(run_path) : fs::path(run_path).parent_path();
  const fs::path file = folder / study_file_name;
  if (!fs::exists(file, ignored)) return {};
  return read_study(file.string());
}

Study find_study(const std::string& path) {
  std::error_code ignored;
  return read_study(fs::is_directory(path, ignored) ? (fs::path(path) / study_file_name).string() : path);
}

bool is_study(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    return fs::exists(fs::path(path) / study_file_name, ignored) &&
           !fs::exists(fs::path(path) / "run.h5", ignored);
  return fs::path(path).filename() == study_file_name;
}

ExitStatus report_study(const Study& study, OutputFolder& folder, Stages& stages, const Options& options,
                        Talk& talk) {
  write_study(study, folder);
  stages.begin("figures");
  const std::vector<Picture> pictures = draw_figures(study_figures(study.result), study.result.title, folder);
  stages.end();
  const StudyReport report = evaluate_study(study, stages);
  stages.begin("report");
  put_in_place(report, shown_work_precision(study.result, pictures), folder, stages);
  say_orders(study.result, talk);
  say_front(study.result, talk);
  say_cheapest(fmt::format("Cheapest time integration of {}",
                           counted(study.result.fixed_elements, "element", "elements")),
               study.result.time_cheapest, talk);
  say_cheapest("Cheapest method and mesh against the converged solution", study.result.total_cheapest, talk);
  say_references(study.result, talk);
  say_verdicts(report.verdicts, talk);
  return say_end(report, folder, stages, options, talk);
}

}  // namespace plumb
