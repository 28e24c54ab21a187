#include "report/study/work_precision/study_pictures.h"

#include "render/gl/gl_context.h"
#include "report/study/work_precision/work_precision_figures.h"

namespace plumb {

std::vector<Picture> draw_study(const WorkPrecision& study, OutputFolder& folder) {
  const GlContext context;
  return draw_figures(study_figures(study), context, picture_texts(context, study.title), folder);
}

}  // namespace plumb
