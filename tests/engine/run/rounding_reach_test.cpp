#include "engine/run/rounding_reach.h"

#include <gtest/gtest.h>

#include "engine/case/case_source.h"
#include "engine/integrate/integrate.h"
#include "engine/run/probes.h"

namespace plumb {
namespace rounding_reach_test {

/// The pendulum at the softening f for a time (s), with what a rounding does to its columns.
ProbeTable reach_of(const std::string& f, const std::string& end) {
  const Case spec = load_case(PLUMB_SOURCE_DIR "/cases/pendulum.toml",
                              {"parameters.f=" + f, "time.end=" + end, "method.name=rk4", "method.step=1e-4"})
                        .spec;
  return rounding_reach(spec, probe(spec, integrate(spec)));
}

TEST(RoundingReach, OfARegularMotionIsSmallAndNeverFalls) {
  const ProbeTable reach = reach_of("5", "0.5");
  ASSERT_FALSE(reach.columns.empty());
  for (const Column& column : reach.columns) {
    EXPECT_TRUE(std::is_sorted(column.values.begin(), column.values.end())) << column.name;
    EXPECT_GT(column.values.back(), 0) << column.name;
    EXPECT_LT(column.values.back(), 1e-10) << column.name;
  }
}

TEST(RoundingReach, OfAMotionThatIsNotPredictableItTellsSo) {
  const ProbeTable reach = reach_of("1", "4");
  double greatest = 0;
  for (const Column& column : reach.columns) greatest = std::max(greatest, column.values.back());
  EXPECT_GT(greatest, 1e-2) << "two such runs are a centimetre apart within 4 s";
}

}  // namespace rounding_reach_test
}  // namespace plumb
