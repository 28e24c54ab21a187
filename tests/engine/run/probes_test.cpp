#include "engine/run/probes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/support_motion.h"
#include "tests/engine/made_case.h"

namespace plumb {
namespace probes_test {

/// A cable of 2 m, whose last node is `tip` from its first in the frame of the supports, at rest there.
Trajectory carried(const Case& spec, const Vec3& tip, const Vec3& from = Vec3::Zero()) {
  Trajectory trajectory;
  trajectory.elements = 1;
  trajectory.element_length = spec.cable.length;
  for (const double t : {0.0, 0.4, 1.0}) {
    Eigen::VectorXd q(12), v = Eigen::VectorXd::Zero(12);
    q << from, 1, 0, 0, from + tip, 1, 0, 0;
    SupportMotion(spec).at(t).to_ground(q, v);
    trajectory.times.push_back(t);
    trajectory.q.push_back(q);
    trajectory.v.push_back(v);
  }
  return trajectory;
}

Case one_element(const std::string& supports) {
  return load_case(CaseSource{{"carried.toml", std::string("title = \"Carried\"\n") + soft_cable +
                                                   "elements = 1\n" + supports +
                                                   R"([method]
name = "rk4"
step = 0.1
[time]
end = 1.0
output_interval = 0.5
[[probe]]
name = "tip"
at = 1.0
quantity = "relative-position"
[[probe]]
name = "ground"
at = 1.0
)"},
                              {},
                              {}})
      .spec;
}

TEST(Probes, ARelativePositionStaysWhereTheSupportsCarryACableAlong) {
  const Case spec = one_element(R"t([supports]
first = "clamped"
first_motion = { x = "t", y = "sin(3*t)", z = "-t^2" }
first_rotation = { axis = [1, 2, 3], angle = "5*t" }
)t");
  const Vec3 tip(1.9, 0.25, -0.125);
  const ProbeTable table = probe(spec, carried(spec, tip));
  for (std::size_t k = 0; k < table.times.size(); ++k)
    for (Eigen::Index c = 0; c < 3; ++c)
      EXPECT_NEAR(table.columns[static_cast<std::size_t>(c)].values[k], tip[c], 1e-14)
          << table.columns[static_cast<std::size_t>(c)].name << " at " << table.times[k] << " s";
  EXPECT_GT(std::abs(table.find("ground.z")->values[2] - tip[2]), 0.1) << "in the ground it moves";
}

TEST(Probes, ARelativePositionOfAFreeCableIsFromItsFirstEnd) {
  const Case spec = one_element("");
  const ProbeTable table = probe(spec, carried(spec, {2, 1, 0}, {10, -3, 4}));
  EXPECT_DOUBLE_EQ(table.find("tip.x")->values[1], 2);
  EXPECT_DOUBLE_EQ(table.find("tip.y")->values[1], 1);
  EXPECT_DOUBLE_EQ(table.find("ground.x")->values[1], 12);
}

}  // namespace probes_test
}  // namespace plumb
