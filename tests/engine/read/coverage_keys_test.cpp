#include <gtest/gtest.h>

#include "tests/engine/given_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace coverage_keys_test {

const std::string good = "t,tip.y\n0,0\n0.5,-0.25\n1,-1\n";

/// The case with `keys` in its [[reference]], of 0, 0.5 and 1 s.
CaseSource with_reference_keys(const std::string& keys) {
  CaseSource source = given_case(good);
  source.file.text = with(source.file.text, "tolerance = 0.125\n", "tolerance = 0.125\n" + keys + "\n");
  return source;
}

TEST(CoverageKeys, AreReadAndAreAllWhereThereIsNone) {
  const CoverageSpec none = load_case(given_case(good)).spec.references.at(0).coverage;
  EXPECT_EQ(none, CoverageSpec{});
  EXPECT_TRUE(none.has(0) && none.has(1e9));
  const LoadedCase loaded = load_case(with_reference_keys("coverage = { from = 0.25, to = 1, share = 0.5 }"));
  EXPECT_EQ(loaded.spec.references.at(0).coverage, (CoverageSpec{0.25, 1, 0.5}));
  EXPECT_EQ(load_case(with_reference_keys("coverage = {}")).spec.references.at(0).coverage, CoverageSpec{});
  const LoadedCase run =
      load_case(given_case(good, "",
                           "[[run]]\nname = \"other\"\nfile = \"chrono.csv\"\ntolerances = { "
                           "\"tip.y\" = 1 }\ncoverage = { to = 0.5 }\n"));
  EXPECT_EQ(run.spec.given_runs.at(1).coverage, (CoverageSpec{{}, 0.5, 1}));
  EXPECT_EQ(run.spec.given_runs.at(0).coverage, CoverageSpec{});
}

TEST(CoverageKeys, EndsOfWhatIsClaimedAreWithinItButForRounding) {
  const CoverageSpec claimed{0.3, 0.6, 1};
  EXPECT_TRUE(claimed.has(0.1 + 0.2) && claimed.has(0.3) && claimed.has(0.6 + 1e-12));
  EXPECT_FALSE(claimed.has(0.2999) || claimed.has(0.6001));
}

TEST(CoverageKeys, EachBadValueIsRefusedWithWhatIsAllowed) {
  const struct {
    std::string keys, expected;
  } faults[] = {
      {"coverage = { share = 0 }", "coverage.share = 0: must be a number greater than 0 and of at most 1"},
      {"coverage = { share = -1 }", "coverage.share = -1: must be a number greater than 0"},
      {"coverage = { share = 1.5 }", "coverage.share = 1.5: must be a number greater than 0"},
      {"coverage = { share = nan }", "coverage.share = nan: must be finite: a number greater than 0"},
      {"coverage = { to = inf }", "coverage.to = inf: must be finite: a number greater than 0 (s)"},
      {"coverage = { to = 0 }", "coverage.to = 0: must be a number greater than 0 (s)"},
      {"coverage = { from = -0.5 }", "coverage.from = -0.5: must be a number of at least 0 (s)"},
      {"coverage = { from = 0.5, to = 0.5 }", "coverage.to = 0.5: must be greater than from, 0.5 (s)"},
      {"coverage = { to = 0.4 }",
       "coverage.to = 0.4: leaves no time of known.toml after t = 0, which are to 1 s"},
      {"coverage = { from = 1.1 }",
       "coverage.from = 1.1: leaves no time of known.toml after t = 0, which are to 1 s"},
      {"coverage = { form = 0.5 }", "coverage.form = 0.5: unknown key; did you mean \"from\"?"},
      {"coverage = 0.5", "coverage = 0.5: must be a table, found a number"},
      {"covrage = {}", "covrage: unknown table; did you mean \"coverage\"?"},
  };
  for (const auto& [keys, expected] : faults) {
    const std::string message = refusal(with_reference_keys(keys));
    EXPECT_TRUE(message.starts_with("case.toml:22:")) << message;
    EXPECT_NE(message.find(" reference.0." + expected), std::string::npos) << keys << "\n"
                                                                           << message << "\n"
                                                                           << expected;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(CoverageKeys, OfARunWithoutTolerancesIsRefused) {
  const std::string message = refusal(given_case(good, "coverage = { to = 0.5 }\n"));
  EXPECT_NE(message.find("run.0.coverage"), std::string::npos) << message;
  EXPECT_NE(message.find("belongs to tolerances, of which the run has none"), std::string::npos) << message;
}

TEST(CoverageKeys, AToleranceThatIsNoFiniteNumberIsRefused) {
  for (const char* bad : {"inf", "nan", "-inf", "0"}) {
    CaseSource source = given_case(good);
    source.file.text = with(source.file.text, "tolerance = 0.125", "tolerance = " + std::string(bad));
    EXPECT_NE(refusal(source).find("a number greater than 0"), std::string::npos) << refusal(source);
    const std::string run =
        refusal(given_case(good, "",
                           "[[run]]\nname = \"other\"\nfile = \"chrono.csv\"\ntolerances = { \"tip.y\" = " +
                               std::string(bad) + " }\n"));
    EXPECT_NE(run.find("a number greater than 0"), std::string::npos) << run;
  }
}

TEST(CoverageKeys, TimesBeyondTheEndOfTheRunAreRemarkedOnUnlessTheyAreNotClaimed) {
  const auto remarks = [](const std::string& keys) {
    CaseSource source = with_reference_keys(keys);
    source.overrides = {"time.end=0.5"};
    std::string all;
    for (const std::string& remark : load_case(source).remarks) all += remark + "\n";
    return all;
  };
  EXPECT_NE(remarks("").find("1 of the 3 times of known.toml are beyond the end of the run, 0.5 s"),
            std::string::npos)
      << remarks("");
  EXPECT_EQ(remarks("coverage = { to = 0.5 }").find("beyond"), std::string::npos);
}

}  // namespace coverage_keys_test
}  // namespace plumb
