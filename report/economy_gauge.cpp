#include "report/economy_gauge.h"

#include <memory>

#include "render/picture_gauge.h"

namespace plumb {

MakeGauge gauge_maker(const Case& spec) {
  return [input = scene_input(spec)](const Trajectory& truth) -> PictureErrors {
    const auto gauge = std::make_shared<const PictureGauge>(truth, input);
    return [gauge](const Trajectory& drawn) { return gauge->distances(drawn); };
  };
}

}  // namespace plumb
