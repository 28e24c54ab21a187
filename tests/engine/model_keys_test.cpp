#include <gtest/gtest.h>

#include "tests/engine/small_case.h"

namespace plumb {
namespace {

CaseSource small_with(const std::string& from, const std::string& to) {
  CaseSource source = small_case();
  source.file.text = with(source.file.text, from, to);
  return source;
}

TEST(ModelKeys, AForceOnTheLastEndIsRead) {
  EXPECT_EQ(load_case(small_case()).spec.loads.end_force, Vec3(0, 0, 0));
  EXPECT_EQ(load_case(small_with("[loads]", "[loads]\nend_force = [1, \"2 * f\", -3]")).spec.loads.end_force,
            Vec3(1, 10, -3));
}

TEST(ModelKeys, AForceThatIsNotThreeNumbersIsRefused) {
  EXPECT_TRUE(matches(refusal(small_with("[loads]", "[loads]\nend_force = [1, 2]")),
                      "case.toml:22:13: loads.end_force = [1, 2]: must be a list of 3 numbers, found 2 of them"))
      << refusal(small_with("[loads]", "[loads]\nend_force = [1, 2]"));
}

TEST(ModelKeys, AnAxialSpeedIsRead) {
  EXPECT_EQ(load_case(small_case()).spec.start.axial_speed, 0);
  EXPECT_EQ(load_case(small_with("[start]", "[start]\naxial_speed = \"-f/2\"")).spec.start.axial_speed, -2.5);
}

TEST(ModelKeys, AnAxialSpeedThatIsNotANumberIsRefused) {
  const std::string message = refusal(small_with("[start]", "[start]\naxial_speed = true"));
  EXPECT_TRUE(matches(message, "case.toml:15:15: start.axial_speed = true: must be a number (m/s), found a boolean")) << message;
}

}  // namespace
}  // namespace plumb
