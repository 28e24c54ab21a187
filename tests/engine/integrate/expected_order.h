#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/engine/pendulum.h"

namespace plumb {

/// A method of fixed step with its order, and the longer of the two steps (s) by which a motion of some
/// tenths of a second shows it.
struct ExpectedOrder {
  const char* name;
  double step, order;
};

inline constexpr ExpectedOrder expected_orders[]{{"velocity-verlet", 1e-3, 2},
                                                 {"rk4", 2e-3, 4},
                                                 {"linearly-implicit-euler", 1e-4, 1},
                                                 {"implicit-euler", 1e-4, 1},
                                                 {"trapezoidal", 1e-3, 2},
                                                 {"hht", 1e-3, 2},
                                                 {"generalized-alpha", 1e-3, 2},
                                                 {"implicit-midpoint", 1e-3, 2},
                                                 {"energy-momentum", 1e-3, 2},
                                                 {"bdf", 5e-4, 2},
                                                 {"gauss", 4e-3, 6},
                                                 {"runge-kutta-nystrom", 1e-2, 8}};

/// Holds the order seen by two runs of a case, from both sides. `error` of a run is a distance from its true
/// motion.
inline void expect_order(const ExpectedOrder& expected, const Case& spec, const TimeSpec& time,
                         const std::function<double(const Trajectory&)>& error, const std::string& of_what) {
  double previous = 0;
  std::string seen = fmt::format("{}, {}", expected.name, of_what);
  for (const double h : {expected.step, expected.step / 2}) {
    const Trajectory trajectory = run(spec, method(expected.name, h), time);
    ASSERT_EQ(trajectory.outcome, Outcome::completed) << seen << trajectory.message;
    const double off = error(trajectory);
    seen += fmt::format("\n  h = {:g}: {:.3g} m", h, off);
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / off), expected.order, expected.order > 4 ? 1.5 : 0.3) << seen;
    }
    previous = off;
  }
}

}  // namespace plumb
