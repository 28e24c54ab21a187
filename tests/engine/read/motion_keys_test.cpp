#include <gtest/gtest.h>

#include "tests/engine/small_case.h"

namespace plumb {
namespace motion_keys_test {

CaseSource with_motion(std::vector<std::string> overrides) {
  CaseSource source = small_case();
  source.overrides = std::move(overrides);
  return source;
}

TEST(MotionKeys, AreReadWithTheirDefaults) {
  const Case spec = load_case(with_motion({"supports.first=clamped", "supports.last=pinned",
                                           "supports.first_motion={ x = \"f*t\", z = \"sin(t)\" }",
                                           "supports.last_motion={ y = \"t^2\" }",
                                           "supports.first_rotation={ axis = [0, 3, 4], angle = \"2*t\" }"}))
                        .spec;
  EXPECT_EQ(spec.supports.first_motion, (MotionSpec{"f*t", "0", "sin(t)"}));
  EXPECT_EQ(spec.supports.last_motion, (MotionSpec{"0", "t^2", "0"}));
  ASSERT_TRUE(spec.supports.first_rotation);
  EXPECT_EQ(spec.supports.first_rotation->angle, "2*t");
  EXPECT_LE((spec.supports.first_rotation->axis - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_FALSE(load_case(small_case()).spec.supports.move());
}

TEST(MotionKeys, OfSmoothMotionsAreTaken) {
  for (const char* smooth : {"sin(1000*t)", "t < 0.5 ? t^2 : t - 0.25", "1e-9*t^3", "0.3*t", "exp(-9*t)-1"})
    EXPECT_EQ(refusal(with_motion({std::string("supports.first_motion={ y = \"") + smooth + "\" }"})),
              "accepted")
        << smooth;
}

struct Refused {
  std::vector<std::string> overrides;
  std::string expected;
};

TEST(MotionKeys, OfABadValueAreRefusedWithWhatIsAllowed) {
  const std::string turned = "supports.first_rotation={ axis = [0, 0, 1], angle = \"t\" }";
  for (const Refused& bad : std::vector<Refused>{
           {{"supports.first_motion={ x = \"sin(\" }"},
            "…supports.first_motion.x = \"sin(\": not a valid expression: unexpected end of expression"},
           {{"supports.first_motion={ x = \"u*t\" }"},
            "…supports.first_motion.x = \"u*t\": unknown parameter \"u\"; known: f, g"},
           {{"supports.first_motion={ w = \"t\" }"},
            "…supports.first_motion.w = \"t\": unknown key; known: x, y, z"},
           {{"supports.first_motion={ x = 1 }"},
            "…supports.first_motion.x = 1: must be a string, found a whole number"},
           {{"supports.first_motion=1"}, "…=1: must be a table, found a whole number"},
           {{"supports.first_motion={ x = \"1+t\" }"},
            "…supports.first_motion.x = \"1+t\": is 1 at t = 0; must be 0, as it is counted from the start"},
           {{"supports.first_motion={ x = \"t/(t-1)\" }"},
            "…supports.first_motion.x = \"t/(t-1)\": is inf at t = 1 s; must be finite"},
           {{"supports.first_motion={ x = \"sqrt(t)\" }"},
            "…supports.first_motion.x = \"sqrt(t)\": its rate is inf at t = 0 s; must be finite"},
           {{"supports.first_motion={ x = \"t<0.3?0:1\" }"},
            "…supports.first_motion.x = \"t<0.3?0:1\": jumps at t = 0.3 s; must not"},
           {{"supports.first_motion={ x = \"max(0,t-0.3)\" }"},
            "…supports.first_motion.x = \"max(0,t-0.3)\": its rate jumps at t = 0.3 s; must not"},
           {{"supports.last_motion={ x = \"t\" }"}, "…: moves an end that is held; supports.last is free"},
           {{"supports.first=free", "supports.first_motion={ x = \"t\" }"},
            "…: moves an end that is held; supports.first is free"},
           {{turned}, "…: turns an end that is clamped; supports.first is another"},
           {{"supports.first=clamped", "supports.last=clamped", turned},
            "…: is computed in a frame that turns with the first end, in which a clamp of the last one would "
            "turn; supports.last must not be clamped"},
           {{"supports.first=clamped", "supports.first_rotation={ axis = [0, 0, 0], angle = \"t\" }"},
            "…supports.first_rotation.axis = [0, 0, 0]: must not be zero"},
           {{"supports.first=clamped", "supports.first_rotation={ angle = \"t\" }"},
            "…supports.first_rotation.axis: missing; required: a list of 3 numbers"},
           {{"supports.first=clamped", "supports.first_rotation={ axis = [0, 0, 1] }"},
            "…supports.first_rotation.angle: missing; required: angle"},
           {{"supports.first=clamped", "supports.first_rotation={ axis = [0, 0, 1], angle = \"t+1\" }"},
            "…supports.first_rotation.angle = \"t+1\": is 1 at t = 0; must be 0, as it is counted from the "
            "start"},
           {{"supports.first=clamped", turned, "method.name=energy-momentum", "method.step=1e-3"},
            "--set supports.first_rotation…methods that take it: velocity-verlet, rk4, arkode-erk, "
            "linearly-implicit-euler, implicit-euler, trapezoidal, hht, generalized-alpha, "
            "implicit-midpoint, arkode-dirk, gauss, bdf, cvode-adams, cvode-bdf, ida, statics"},
           {{"supports.first=clamped", turned, "method.name=runge-kutta-nystrom", "method.step=1e-3"},
            "…is not taken by runge-kutta-nystrom, as forces in a frame that turns depend on rates and have "
            "no potential; methods that take it: velocity-verlet, rk4, arkode-erk, linearly-implicit-euler, "
            "implicit-euler, trapezoidal, hht, generalized-alpha, implicit-midpoint, arkode-dirk, gauss, "
            "bdf, cvode-adams, cvode-bdf, ida, statics"},
           {{"cable.model=rigid", "method.name=rk4", "method.step=1e-3", "probe.1.quantity=position",
             "probe.1.name=pull", "supports.first_motion={ x = \"t\" }"},
            "…: not of a rigid rod, whose joint stays where it is"},
       }) {
    const std::string message = refusal(with_motion(bad.overrides));
    EXPECT_TRUE(matches(message, bad.expected)) << "refused:  " << message << "\nexpected: " << bad.expected;
  }
}

}  // namespace motion_keys_test
}  // namespace plumb
