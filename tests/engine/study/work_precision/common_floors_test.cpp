#include "engine/study/work_precision/common_floors.h"

#include <gtest/gtest.h>

namespace plumb {
namespace study_common_floors_test {

const std::vector<double> flat_at_1e_6{1e-3, 1e-5, 1.1e-6, 1e-6, 1.2e-6};
const std::vector<double> falling{1e-3, 1e-4, 1e-5, 1e-6, 1e-7};

TEST(StudyCommonFloors, ThreeMethodsThatFlattenTogetherAreFlagged) {
  const auto floors = common_floors(
      {{"a", flat_at_1e_6}, {"b", falling}, {"c", {1e-2, 1.3e-6, 1.2e-6, 1.25e-6}}, {"d", flat_at_1e_6}});
  ASSERT_EQ(floors.size(), 1U);
  EXPECT_NEAR(floors[0].error, 1.14e-6, 0.05e-6);
  EXPECT_EQ(floors[0].curves, (std::vector<std::size_t>{0, 2, 3}));
}

TEST(StudyCommonFloors, CurvesOfOneMethodOrOfDifferentLevelsAreNot) {
  EXPECT_TRUE(common_floors({{"a", flat_at_1e_6}, {"a", flat_at_1e_6}, {"a", flat_at_1e_6}}).empty());
  EXPECT_TRUE(common_floors({{"a", flat_at_1e_6}, {"b", {1, 1, 1}}, {"c", {2, 2, 2}}}).empty());
  EXPECT_TRUE(common_floors({{"a", falling}, {"b", falling}, {"c", falling}}).empty());
  EXPECT_TRUE(common_floors({{"a", {1, 1, -1}}, {"b", {1, 1, -1}}, {"c", {1, 1, -1}}}).empty());
}

}  // namespace study_common_floors_test
}  // namespace plumb
