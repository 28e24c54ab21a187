#include "engine/run/centerline_from_probes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/engine/given_case.h"

namespace plumb {
namespace curve_through_probes_test {

/// A case of a cable of 2 m with positions (and slopes) at some places, moving as the curve r(s, t) =
/// (s, a s² t, 0) with s in m.
struct Bent {
  LoadedCase loaded;
  DrawnCurve curve;
};

Bent bent(const std::vector<double>& places, bool with_slopes, const std::string& first) {
  std::string probes, header = "t", rows;
  for (std::size_t k = 0; k < places.size(); ++k) {
    probes += fmt::format("[[probe]]\nname = \"p{}\"\nat = {}\n", k, places[k]);
    header += fmt::format(",p{0}.x,p{0}.y,p{0}.z", k);
    if (!with_slopes) continue;
    probes += fmt::format("[[probe]]\nname = \"d{}\"\nat = {}\nquantity = \"slope\"\n", k, places[k]);
    header += fmt::format(",d{0}.x,d{0}.y,d{0}.z", k);
  }
  for (const double t : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    rows += fmt::format("{}", t);
    for (const double at : places) {
      const double s = 2 * at;
      rows += fmt::format(",{},{},0", s, 0.1 * s * s * t);
      if (with_slopes) rows += fmt::format(",1,{},0", 0.2 * s * t);
    }
    rows += "\n";
  }
  CaseSource source =
      given_case(header + "\n" + rows, "", probes + "[supports]\nfirst = \"" + first + "\"\n");
  const std::size_t reference = source.file.text.find("[[reference]]");
  source.file.text.erase(reference, source.file.text.find("[[probe]]", reference) - reference);
  Bent result{load_case(source), {}};
  result.curve = curve_through_probes(result.loaded.spec, result.loaded.given_runs[0], "chrono", 10);
  return result;
}

/// Greatest distance of the drawn nodes from r(s, t).
double worst(const Trajectory& motion, double from, double to) {
  double distance = 0;
  for (std::size_t k = 0; k < motion.times.size(); ++k)
    for (int node = 0; node <= motion.elements; ++node) {
      const double s = 2 * (from + (to - from) * node / motion.elements);
      const Vec3 expected{s, 0.1 * s * s * motion.times[k], 0};
      distance = std::max(distance, (motion.q[k].segment<3>(6 * node) - expected).norm());
    }
  return distance;
}

TEST(CurveThroughProbes, PositionsAndSlopesGiveTheTrueCurveWhereItIsCubicAlongTheCable) {
  const Bent made = bent({0, 0.5, 1}, true, "free");
  ASSERT_TRUE(made.curve.motion.has_value()) << made.curve.in_words;
  EXPECT_LT(worst(*made.curve.motion, 0, 1), 1e-14);
  EXPECT_NEAR(made.curve.motion->v.back()[6 * 64 + 1], 0.4, 1e-12)
      << "rate of the height of the last end, m/s";
  EXPECT_EQ(made.curve.motion->times.size(), 11U) << "ten frames a second over a second";
  EXPECT_NE(made.curve.in_words.find("positions and slopes which it gives at 3 places"), std::string::npos)
      << made.curve.in_words;
}

TEST(CurveThroughProbes, PositionsAloneGiveACurveThroughThemThatIsNotTheTrueOneBetween) {
  const Bent made = bent({0.25, 0.5, 1}, false, "pinned");
  ASSERT_TRUE(made.curve.motion.has_value()) << made.curve.in_words;
  const Trajectory& motion = *made.curve.motion;
  for (const int node : {0, 16, 32, 64}) {
    const double s = 2.0 * node / 64;
    EXPECT_NEAR((motion.q.back().segment<3>(6 * node) - Vec3(s, 0.1 * s * s, 0)).norm(), 0, 1e-14) << node;
  }
  EXPECT_GT(worst(motion, 0, 1), 1e-4);
  EXPECT_NE(
      made.curve.in_words.find("drawn through 4 places (the held first end, p0, p1, p2), as a natural cubic"),
      std::string::npos)
      << made.curve.in_words;
}

TEST(CurveThroughProbes, TwoPlacesGiveAStraightLine) {
  const Bent made = bent({0.5, 1}, false, "free");
  ASSERT_TRUE(made.curve.motion.has_value()) << made.curve.in_words;
  const Eigen::VectorXd& q = made.curve.motion->q.back();
  EXPECT_NEAR(q[6 * 32 + 1], (0.1 + 0.4) / 2, 1e-14) << "height half way between 0.1 and 0.4 m";
  EXPECT_NEAR(made.curve.motion->element_length * 64, 1, 1e-15) << "m, from the middle to the last end";
  EXPECT_NE(made.curve.in_words.find("as a straight line"), std::string::npos) << made.curve.in_words;
}

TEST(CurveThroughProbes, OnePlaceIsNotEnoughUnlessTheFirstEndIsHeld) {
  EXPECT_FALSE(bent({1}, false, "free").curve.motion.has_value());
  EXPECT_NE(bent({1}, false, "free").curve.in_words.find("at one place only, p0"), std::string::npos)
      << bent({1}, false, "free").curve.in_words;
  EXPECT_TRUE(bent({1}, false, "pinned").curve.motion.has_value());
}

TEST(CurveThroughProbes, PlacesTooFarToBeSeenAreNotDrawn) {
  const LoadedCase loaded = load_case(
      given_case("t,tip.x,tip.y,tip.z\n0,1,0,0\n1,1e30,0,0\n", "", "[supports]\nfirst = \"pinned\"\n"));
  const DrawnCurve curve = curve_through_probes(loaded.spec, loaded.given_runs[0], "chrono", 10);
  EXPECT_FALSE(curve.motion.has_value());
  EXPECT_NE(curve.in_words.find("more than 1000 lengths"), std::string::npos) << curve.in_words;
}

}  // namespace curve_through_probes_test
}  // namespace plumb
