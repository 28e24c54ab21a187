#include "report/study/uncertainty/budget_pictures.h"

#include "render/gl/gl_context.h"
#include "report/study/uncertainty/budget_figure.h"

namespace plumb {

std::vector<Picture> draw_budget(const ErrorBudget& budget, OutputFolder& folder) {
  const GlContext context;
  const Figure figure = budget_figure(budget);
  return draw_figures({figure}, context, picture_texts(context, figure.title), folder);
}

}  // namespace plumb
