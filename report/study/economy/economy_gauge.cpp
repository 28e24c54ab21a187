#include "report/study/economy/economy_gauge.h"

#include <memory>

#include "render/scene/image_error.h"

namespace plumb {

MakeGauge gauge_maker(const Case& spec) {
  return [input = scene_input(spec)](const Trajectory& truth) -> PictureErrors {
    const auto gauge = std::make_shared<const ImageErrorGauge>(truth, input);
    return [gauge](const Trajectory& drawn) { return gauge->distances(drawn); };
  };
}

}  // namespace plumb
