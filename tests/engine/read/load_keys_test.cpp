#include <gtest/gtest.h>

#include "tests/engine/small_case.h"

namespace plumb {
namespace load_keys_test {

/// The small case with more tables at its end, and with overrides.
CaseSource with_tables(const std::string& tables, std::vector<std::string> overrides = {}) {
  CaseSource source = small_case();
  source.file.text += "\n" + tables + "\n";
  source.overrides = std::move(overrides);
  return source;
}

TEST(LoadKeys, AreReadWithTheirDefaults) {
  const Case spec = load_case(with_tables("[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, \"g\", 2]\n"
                                          "[[load]]\nkind = \"distributed\"\nvalue = [1, 2, 3]\n"
                                          "follows = true\nfactor = \"sin(f * t)\"\n"
                                          "[[mass]]\nat = 0.5\nmass = \"g / 5\"\n"
                                          "[damping]\nmass = 0.5\nmaterial = 1e-3"))
                        .spec;
  ASSERT_EQ(spec.loads.applied.size(), 2U);
  EXPECT_EQ(spec.loads.applied[0], (LoadSpec{LoadKind::force, 1, {0, 10, 2}, false, "1"}));
  EXPECT_EQ(spec.loads.applied[1], (LoadSpec{LoadKind::distributed, 0, {1, 2, 3}, true, "sin(f * t)"}));
  EXPECT_EQ(spec.masses, (std::vector<MassSpec>{{0.5, 2}}));
  EXPECT_EQ(spec.damping, (DampingSpec{0.5, 1e-3}));
  EXPECT_EQ(spec.start.stretch, 1);
}

TEST(LoadKeys, TakeOverridesByNumber) {
  const Case spec =
      load_case(with_tables("[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, 1, 2]",
                            {"load.0.value=[3,4,5]", "load.0.follows=true", "start.stretch=1.5"}))
          .spec;
  EXPECT_EQ(spec.loads.applied.at(0), (LoadSpec{LoadKind::force, 1, {3, 4, 5}, true, "1"}));
  EXPECT_EQ(spec.start.stretch, 1.5);
}

struct Refused {
  std::string tables, expected;
  std::vector<std::string> overrides = {};
};

TEST(LoadKeys, OfABadValueAreRefusedWithTheirPlaceAndWhatIsAllowed) {
  const std::string force = "[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, 1, 0]\n";
  for (const Refused& bad : std::vector<Refused>{
           {"[[load]]\nkind = \"push\"\nat = 1\nvalue = [0, 1, 0]",
            "case.toml:72:8: load.0.kind = \"push\"…"},
           {"[[load]]\nat = 1\nvalue = [0, 1, 0]",
            "case.toml:71:1: load.0.kind: missing; required: \"force\", \"moment\" or \"distributed\""},
           {"[[load]]\nkind = \"force\"\nat = 1", "case.toml:71:1: load.0.value: missing; required: …"},
           {"[[load]]\nkind = \"force\"\nvalue = [0, 1, 0]",
            "case.toml:71:1: load.0.at: is missing: where the "
            "load acts, from 0 to 1 (fraction of the length)"},
           {"[[load]]\nkind = \"force\"\nat = 1.5\nvalue = [0, 1, 0]",
            "case.toml:73:6: load.0.at = 1.5: must be a number from 0 to 1 (fraction of the length)"},
           {"[[load]]\nkind = \"distributed\"\nat = 1\nvalue = [0, 1, 0]",
            "case.toml:73:6: load.0.at = 1: not a key of a distributed load, which is everywhere"},
           {"[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, 1]", "case.toml:74:9: load.0.value = [0, 1]…"},
           {force + "follows = 1", "case.toml:75:11: load.0.follows = 1…"},
           {force + "when = 1", "case.toml:75:1: load.0.when = 1: unknown key…"},
           {force + "factor = \"sin(\"",
            "case.toml:75:15: load.0.factor = \"sin(\": not a valid expression: …"},
           {force + "factor = \"u * t\"",
            "case.toml:75:11: load.0.factor = \"u * t\": unknown parameter \"u\"…"},
           {force + "factor = \"1 / (t - 1)\"",
            "case.toml:75:10: load.0.factor = \"1 / (t - 1)\": is …at t = 1 s; must be finite"},
           {"[[load]]\nkind = \"moment\"\nat = 1\nvalue = [3, 0, 4]",
            "case.toml:74:9: load.0.value = [3, 0, 4]: a moment must be across the cable at the start: …"},
           {"[[load]]\nkind = \"moment\"\nat = 1\nvalue = [0, 1, 1]",
            "case.toml:74:9: load.0.value = [0, 1, 1]: a moment must be across the cable at the start: …"},
           {"[[load]]\nkind = \"moment\"\nat = 1\nvalue = [3, 1, 4]\nfollows = true",
            "case.toml:74:9: load.0.value = [3, 1, 4]: a moment must be across the cable at the start: …"},
           {"[[load]]\nkind = \"moment\"\nat = 1\nvalue = [0, 1, 0]",
            "case.toml:72:8: load.0.kind = \"moment\": a chain does not bend, …",
            {"cable.model=chain"}},
           {"[[mass]]\nmass = 1", "case.toml:71:1: mass.0.at: missing; required: …"},
           {"[[mass]]\nat = 1", "case.toml:71:1: mass.0.mass: missing; required: …"},
           {"[[mass]]\nat = 1\nmass = 0",
            "case.toml:73:8: mass.0.mass = 0: must be a number greater than 0 (kg)"},
           {"[[mass]]\nat = -1\nmass = 1",
            "case.toml:72:6: mass.0.at = -1: must be a number from 0 to 1 (fraction of the length)"},
           {"[damping]\nmass = -1",
            "case.toml:72:8: damping.mass = -1: must be a number of at least 0 (1/s)"},
           {"[damping]\nmaterial = -1",
            "case.toml:72:12: damping.material = -1: must be a number of at least 0 (s)"},
           {"[damping]\nmaterial = 1",
            "case.toml:72:12: damping.material = 1: must be 0 for runge-kutta-nystrom, which is made for "
            "forces "
            "that do not depend on rates; methods that take damping: velocity-verlet, rk4, …",
            {"method.name=runge-kutta-nystrom", "method.step=1e-3"}},
           {"[damping]\nmass = 1",
            "case.toml:72:8: damping.mass = 1: must be 0 for runge-kutta-nystrom, …",
            {"method.name=runge-kutta-nystrom", "method.step=1e-3"}},
           {"", "--set start.stretch=0: must be a number from 0.01 to 100", {"start.stretch=0"}},
       }) {
    const std::string message = refusal(with_tables(bad.tables, bad.overrides));
    EXPECT_TRUE(matches(message, bad.expected))
        << bad.tables << "\nrefused:  " << message << "\nexpected: " << bad.expected;
  }
}

TEST(LoadKeys, OfAFactorTakeNoParameterOfTheNameOfTheTime) {
  CaseSource source = with_tables("[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, 1, 0]\nfactor = \"t\"");
  source.file.text = with(source.file.text, "f = 5", "f = 5\nt = 2");
  EXPECT_TRUE(matches(refusal(source),
                      "case.toml:76:10: load.0.factor = \"t\": t is the time here, and a "
                      "parameter must have another name"))
      << refusal(source);
}

TEST(LoadKeys, OfARigidRodTakeWhatDoesNotDeformIt) {
  const std::vector<std::string> rigid{"cable.model=rigid", "method.name=rk4", "method.step=1e-3",
                                       "probe.1.quantity=position", "probe.1.name=pull"};
  const auto message = [&](const std::string& more) {
    std::vector<std::string> overrides = rigid;
    overrides.push_back(more);
    return refusal(with_tables("[damping]", overrides));
  };
  EXPECT_NE(message("damping.material=1").find("must be 0 for a rigid rod, which does not deform"),
            std::string::npos)
      << message("damping.material=1");
  EXPECT_NE(message("start.stretch=1.1").find("must be 1 for a rigid rod, which does not stretch"),
            std::string::npos)
      << message("start.stretch=1.1");
}

}  // namespace load_keys_test
}  // namespace plumb
