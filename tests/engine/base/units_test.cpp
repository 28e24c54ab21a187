#include "engine/base/units.h"

#include <gtest/gtest.h>

namespace plumb {
namespace units_test {

TEST(Units, AFactorTurnsANumberIntoTheBaseUnit) {
  const std::tuple<const char*, const char*, double> expected[] = {{"mm", "m", 1e-3},
                                                                   {"cm", "m", 1e-2},
                                                                   {"km", "m", 1e3},
                                                                   {"in", "m", 0.0254},
                                                                   {"ft", "m", 0.3048},
                                                                   {"m", "m", 1},
                                                                   {"ms", "s", 1e-3},
                                                                   {"us", "s", 1e-6},
                                                                   {"µs", "s", 1e-6},
                                                                   {"min", "s", 60},
                                                                   {"km/h", "m/s", 1 / 3.6},
                                                                   {"mm/s", "m/s", 1e-3},
                                                                   {"kN", "N", 1e3},
                                                                   {"N", "N", 1},
                                                                   {"%", "1", 1e-2},
                                                                   {"1", "1", 1},
                                                                   {"1/mm", "1/m", 1e3},
                                                                   {"1/m", "1/m", 1},
                                                                   {"N m", "N m", 1},
                                                                   {"N mm", "N m", 1e-3},
                                                                   {"lbf", "N", 4.4482216152605}};
  for (const auto& [unit, base, factor] : expected) {
    const auto found = unit_factor(unit, base);
    ASSERT_TRUE(found.has_value()) << unit;
    EXPECT_DOUBLE_EQ(*found, factor) << unit;
  }
}

TEST(Units, SpellingsOfAProductAndOfMicroAreAlike) {
  for (const char* spelling : {"Nmm", "N mm", "N*mm", "N·mm", "N⋅mm"})
    EXPECT_EQ(unit_factor(spelling, "N m"), 1e-3) << spelling;
  EXPECT_EQ(unit_factor("μs", "s"), 1e-6) << "the Greek letter, rather than the sign for micro";
}

TEST(Units, AUnitOfAnotherDimensionOrNoneHasNoFactor) {
  for (const char* unit : {"s", "N", "1/m", "M", "MM", "", "furlong"})
    EXPECT_FALSE(unit_factor(unit, "m").has_value()) << unit;
  EXPECT_FALSE(unit_factor("m", "s").has_value());
}

TEST(Units, AFaultSaysTheDimensionOrTheNearestAndWhatIsAllowed) {
  EXPECT_EQ(unit_fault("ms", "m"),
            "is a unit of time, not of length; allowed: m, mm, cm, um, µm, km, in, ft");
  EXPECT_EQ(unit_fault("mim", "m"),
            "is no known unit; did you mean \"mm\"?; allowed: m, mm, cm, um, µm, km, in, ft");
  EXPECT_EQ(unit_fault("furlong", "s"), "is no known unit; allowed: s, ms, us, µs, min");
}

}  // namespace units_test
}  // namespace plumb
