#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/case/case_source.h"
#include "tests/engine/made_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace mode_keys_test {

/// A reference over another abscissa than time.
NamedText computed(const std::string& title, const std::string& abscissa, const std::string& column,
                   const std::string& unit, const std::string& first_row) {
  return {title + ".toml", fmt::format(R"(title = "{}"
kind = "computed"
source = "a"
obtained = "by hand"
columns = ["{}", "{}"]
rows = [{}, [3, 4.0]]
[[series]]
name = "{}"
figure = "1"
unit = "{}"
uncertainty = 0.1
uncertainty_basis = "guess"
)",
                                       title, abscissa, column, first_row, column, unit)};
}

/// A soft cable, pinned at both ends, whose modes are asked for, with more tables and overrides.
CaseSource source(const std::string& more, const std::vector<std::string>& overrides = {}) {
  CaseSource result{{"case.toml", std::string("title = \"Modes\"\n[supports]\nfirst = \"pinned\"\n") +
                                      soft_cable + "elements = 4\n[method]\nname = \"modes\"\n" + more},
                    overrides,
                    {}};
  result.references.push_back(computed("known", "mode", "f", "Hz", "[1, 2.0]"));
  result.references.push_back(computed("path", "load", "y", "m", "[0.5, 2.0]"));
  result.references.push_back(MadeReference{"[0, 0], [1, 1]", "time.toml"}.text());
  return result;
}

const std::string of_modes =
    "[[reference]]\nfile = \"known.toml\"\ncompare = { f = \"frequency\" }\ntolerance = 1\n";

TEST(ModeKeys, NeedNoTimesAndHaveDefaults) {
  const Case spec = load_case(source("")).spec;
  EXPECT_EQ(spec.method.parameters.at("count"), 10);
  EXPECT_EQ(spec.method.parameters.at("about"), 0) << "the equilibrium";
  EXPECT_EQ(spec.time.end, 1);
  const Case given = load_case(source("count = 3\nabout = \"start\"\n[time]\nend = 2\n")).spec;
  EXPECT_EQ(given.method.parameters.at("count"), 3);
  EXPECT_EQ(given.method.parameters.at("about"), 1);
  EXPECT_EQ(given.time.end, 2);
}

TEST(ModeKeys, OfAnotherMethodAreStillAskedForTimes) {
  EXPECT_NE(refusal(source("", {"method.name=statics", "method.step=0.1"})).find("a table [time]"),
            std::string::npos)
      << refusal(source("", {"method.name=statics", "method.step=0.1"}));
}

TEST(ModeKeys, OutOfTheirRangesAreRefused) {
  for (const auto& [text, part] : {std::pair<std::string, std::string>{"count = 0\n", "method.count"},
                                   {"count = 1.5\n", "method.count"},
                                   {"count = 501\n", "method.count"},
                                   {"about = \"end\"\n", "must be \"equilibrium\" or \"start\""},
                                   {"step = 0.1\n", "not a key of modes"}})
    EXPECT_NE(refusal(source(text)).find(part), std::string::npos) << text << refusal(source(text));
}

TEST(ModeKeys, ReferenceStandsOverNumbersOfModes) {
  const LoadedCase loaded = load_case(source(of_modes));
  ASSERT_EQ(loaded.references.size(), 1U);
  EXPECT_EQ(loaded.references[0].abscissa, Abscissa::mode);
  EXPECT_EQ(loaded.references[0].times, (std::vector<double>{1, 3}));
  EXPECT_TRUE(loaded.remarks.empty()) << loaded.remarks.front();
}

TEST(ModeKeys, ReferenceOverWhatTheRunDoesNotHaveIsRefused) {
  const std::string of_times =
      "[[probe]]\nname = \"p\"\nat = 1\nquantity = \"position\"\n[[reference]]\nfile = "
      "\"time.toml\"\ncompare = { y "
      "= \"p.y\" }\ntolerance = 1\n";
  EXPECT_NE(refusal(source(of_times)).find("its first column is \"t\""), std::string::npos)
      << refusal(source(of_times));
  EXPECT_NE(refusal(source(of_times, {"reference.0.compare={ y = \"greatest p.y\" }"}))
                .find("is read off a motion over time; a run with this method has modes"),
            std::string::npos);
  const std::vector<std::string> moving{"method.name=rk4", "method.step=0.01", "time.end=1",
                                        "time.output_interval=0.5"};
  EXPECT_EQ(refusal(source(of_times, moving)), "accepted");
  std::string of_loads = of_times;
  of_loads.replace(of_loads.find("time.toml"), 9, "path.toml");
  EXPECT_NE(refusal(source(of_loads, moving)).find("its first column is \"load\""), std::string::npos)
      << refusal(source(of_loads, moving));
  EXPECT_NE(refusal(source(of_modes, moving)).find("not a column of the probes"), std::string::npos)
      << refusal(source(of_modes, moving));
}

TEST(ModeKeys, LoadsOfAReferenceAreTheTimesAtWhichStaticsHasThem) {
  const std::string of_loads =
      "[[probe]]\nname = \"p\"\nat = 1\nquantity = \"position\"\n[[reference]]\nfile = "
      "\"path.toml\"\ncompare = { y "
      "= \"p.y\" }\ntolerance = 1\nwhole_load = 6\n[time]\nend = 4\noutput_interval = 1\n";
  const LoadedCase loaded = load_case(source(of_loads, {"method.name=statics", "method.step=1"}));
  EXPECT_NEAR(loaded.references.at(0).times.at(0), 0.5 / 6 * 4, 1e-15);
  EXPECT_NEAR(loaded.references.at(0).times.at(1), 2, 1e-15);
  EXPECT_NE(refusal(source(of_modes + "whole_load = 2\n")).find("reference.0.whole_load"), std::string::npos);
}

TEST(ModeKeys, SpinRefusesWhatDoesNotTurnWithIt) {
  const std::string spinning = "[start]\nangular_velocity = [0, 0, 3]\n";
  EXPECT_EQ(refusal(source(spinning + "[loads]\ngravity = [0, 0, -9.81]\n")), "accepted");
  for (const auto& [text, key] :
       {std::pair<std::string, std::string>{"[loads]\ngravity = [0, -9.81, 0]\n", "loads.gravity"},
        {"[loads]\nend_force = [1, 0, 0]\n", "loads.end_force"},
        {"[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, 1, 0]\n", "load.0.value"},
        {"[damping]\nmass = 1\n", "damping.mass"}})
    EXPECT_NE(refusal(source(spinning + text)).find(key), std::string::npos)
        << text << refusal(source(spinning + text));
  EXPECT_EQ(
      refusal(source(spinning + "[[load]]\nkind = \"force\"\nat = 1\nvalue = [0, 1, 0]\nfollows = true\n")),
      "accepted");
  EXPECT_NE(refusal(source("", {"supports.first_motion.x=sin(t)"})).find("first_motion"), std::string::npos)
      << refusal(source("", {"supports.first_motion.x=sin(t)"}));
  EXPECT_NE(refusal(source("[start]\naxial_speed = 1\n")).find("start.axial_speed"), std::string::npos);
}

TEST(ModeKeys, FiguresStandOverModesAndProbesDoNotTakeTheirNames) {
  const std::string figure = "[[figure]]\nname = \"a\"\ny = \"frequency\"\n";
  EXPECT_EQ(load_case(source(figure)).spec.figures.at(0).x, "mode");
  EXPECT_NE(refusal(source(figure + "x = \"t\"\n")).find("figure.0.x"), std::string::npos);
  EXPECT_NE(
      refusal(source("[[probe]]\nname = \"decay\"\nat = 1\nquantity = \"curvature\"\n")).find("probe.0.name"),
      std::string::npos);
}

TEST(ModeKeys, StudiesOverTimeAreRefused) {
  EXPECT_NE(refusal(source("[uncertainty]\nnumerical = true\n")).find("uncertainty"), std::string::npos);
}

}  // namespace mode_keys_test
}  // namespace plumb
