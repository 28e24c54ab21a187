#include "report/program/run_sections.h"

#include "report/page/history_html.h"
#include "report/page/modes_html.h"
#include "report/program/assessment_pipeline.h"
#include "report/program/scene_choice.h"
#include "report/program/sensitivity_pipeline.h"
#include "report/program/work_precision_pipeline.h"
#include "report/study/economy/economy_section.h"
#include "report/study/sensitivity/sensitivity_section.h"
#include "report/study/uncertainty/budget_section.h"
#include "report/study/uncertainty/uncertainty_section.h"
#include "report/study/work_precision/work_precision_page.h"

namespace plumb {
namespace {

/// In the order of results.json.
std::vector<RunSection> sections_of(const Run& run, const std::optional<Study>& study,
                                    const std::optional<Economy>& economy, const Assessment& assessment,
                                    const std::optional<Sensitivity>& sensitivity) {
  std::vector<RunSection> sections = economy_sections(run, economy);
  if (has_modes(run)) sections.insert(sections.begin(), modes_section(run));
  if (study) sections.insert(sections.begin(), work_precision_section(study->result));
  if (assessment.uncertainty)
    sections.push_back(uncertainty_section(*assessment.uncertainty, run.loaded.spec));
  if (assessment.error_budget) sections.push_back(budget_section(*assessment.error_budget));
  if (sensitivity) sections.push_back(sensitivity_section(*sensitivity));
  return sections;
}

}  // namespace

std::span<const PageSection> page_sections() {
  static const std::vector<PageSection> all{
      modes_on_page(),   uncertainty_on_page(),    budget_on_page(), sensitivity_on_page(),
      economy_on_page(), work_precision_on_page(), history_on_page()};
  return all;
}

std::vector<RunSection> computed_sections(const Run& run, const std::optional<Economy>& economy,
                                          Journal& journal, OutputFolder& folder, Stages& stages,
                                          Console& console, const std::function<void()>& all_timed) {
  std::optional<Study> study;
  // A rigid rod has no methods and meshes to compare.
  if (run.loaded.spec.work_precision && run.loaded.spec.cable.model != CableModel::rigid) {
    stages.begin("study");
    study = quick_study(run.loaded, journal, console);
    write_study(*study, folder);
  }
  all_timed();
  const Assessment assessment = assess(run, journal, stages, console);
  write_assessment(assessment, folder);
  if (run.loaded.spec.sensitivity) stages.begin("sensitivity");
  return sections_of(run, study, economy, assessment, find_sensitivity(run.loaded, journal, folder, console));
}

std::vector<RunSection> sections_beside(const std::string& run_path, const Run& run, OutputFolder& folder) {
  const std::optional<Study> study = study_beside(run_path);
  if (study) write_study(*study, folder);
  const Assessment assessment = assessment_beside(run_path, run);
  write_assessment(assessment, folder);
  return sections_of(run, study, choice_beside(run_path, run, folder), assessment,
                     sensitivity_beside(run_path, run.loaded, folder));
}

}  // namespace plumb
