#include "report/program/drawing_beside.h"

#include <stdexcept>

#include "report/figure/scene_of_run.h"
#include "report/verdict/series_error.h"

namespace plumb {

Pictures draw_all(const Run& run, const std::shared_future<const std::vector<RunSection>*>& sections,
                  OutputFolder& folder, Stages& stages, const DrawingProgress& progress) {
  DrawingTools tools;
  Pictures pictures = draw(run, SceneOfRun(run), series_errors(run), {}, tools, folder, stages, progress);
  for (const RunSection& section : *sections.get()) {
    if (!section.figures) continue;
    if (!section.drawing_stage.empty()) stages.begin(section.drawing_stage);
    std::vector<Picture>& drawn =
        section.figures_key == figures_key ? pictures.figures : pictures.sections[section.figures_key];
    for (Picture& picture : draw_figures(section.figures(), tools, run.loaded.spec.title, folder))
      drawn.push_back(std::move(picture));
    stages.end();
  }
  return pictures;
}

DrawingBeside::DrawingBeside(const Run& run, OutputFolder& folder) {
  const auto draw = [this, &run, &folder, sections = sections_.get_future().share()] {
    return draw_all(run, sections, folder, stages_, [this](double) {
      if (abandoned_) throw std::runtime_error("abandoned");
    });
  };
  pictures_ = std::async(std::launch::async | std::launch::deferred, draw);
}

DrawingBeside::~DrawingBeside() {
  if (finished_) return;
  abandoned_ = true;
  sections_.set_exception(std::make_exception_ptr(std::runtime_error("abandoned")));
}

Pictures DrawingBeside::finish(const std::vector<RunSection>& sections) {
  finished_ = true;
  sections_.set_value(&sections);
  return pictures_.get();
}

}  // namespace plumb
