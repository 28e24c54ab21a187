#include "engine/run/field_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/model/cable.h"
#include "engine/run/cable_field.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace field_map_test {

/// A cable of 1 m that turns at 4 rad/s, whose speed is 4 s at the fraction s; later outputs are faster.
Trajectory turning(int elements, int outputs) {
  const Case spec = pendulum(5, elements);
  const Cable cable(spec);
  Trajectory trajectory;
  trajectory.elements = elements;
  for (int k = 0; k < outputs; ++k) {
    trajectory.times.push_back(0.1 * k);
    trajectory.q.push_back(cable.start_q(spec.start));
    trajectory.v.push_back((1 + k) * cable.start_v(spec.start));
  }
  return trajectory;
}

TEST(FieldMap, HasTheValueOfEachOutputInTheMiddleOfItsCells) {
  const Cable cable(pendulum(5, 4));
  const FieldMap map = field_map(cable, ColorField::speed, turning(4, 3), 10, 9);
  EXPECT_EQ(map.time_edges, (std::vector<double>{0, 0.05, 0.1 / 2 + 0.2 / 2, 0.2}));
  ASSERT_EQ(map.place_edges.size(), 9U) << "twice four elements are no more than nine rows";
  ASSERT_EQ(map.values.size(), 8U * 3U);
  for (std::size_t r = 0; r < 8; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(map.values[3 * r + c], 4 * (static_cast<double>(r) + 0.5) / 8 * static_cast<double>(c + 1),
                  1e-9)
          << r << ", " << c;
}

TEST(FieldMap, OfManyElementsAndOutputsHasMeansInNoMoreCellsThanAllowed) {
  const int elements = 100, outputs = 57;
  const Cable cable(pendulum(5, elements));
  const FieldMap map = field_map(cable, ColorField::speed, turning(elements, outputs), 19, 10);
  ASSERT_EQ(map.time_edges.size(), 20U);
  ASSERT_EQ(map.place_edges.size(), 11U);
  for (std::size_t k = 1; k < map.time_edges.size(); ++k) EXPECT_GT(map.time_edges[k], map.time_edges[k - 1]);
  for (std::size_t r = 0; r < 10; ++r)
    for (std::size_t c = 0; c < 19; ++c) {
      const double expected = 4 * (static_cast<double>(r) + 0.5) / 10 * (3 * static_cast<double>(c) + 2);
      EXPECT_NEAR(map.values[19 * r + c], expected, 1e-9) << "the mean of three outputs";
    }
}

TEST(FieldMap, LeavesOutWhatIsNotFiniteAndHasNoCellsForOneOutput) {
  const Cable cable(pendulum(5, 4));
  Trajectory trajectory = turning(4, 3);
  trajectory.v[1].setConstant(std::numeric_limits<double>::quiet_NaN());
  const FieldMap map = field_map(cable, ColorField::speed, trajectory, 10, 4);
  EXPECT_TRUE(std::isnan(map.values[1]));
  EXPECT_TRUE(std::isfinite(map.values[0]));
  EXPECT_TRUE(field_map(cable, ColorField::speed, turning(4, 1), 10, 4).values.empty());
  EXPECT_TRUE(field_map(cable, ColorField::speed, turning(4, 0), 10, 4).values.empty());
}

}  // namespace field_map_test
}  // namespace plumb
