#include "engine/study/uncertainty/run_uncertainty.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/study/uncertainty/assessment.h"
#include "engine/study/uncertainty/uncertainty_parts.h"
#include "tests/engine/made_case.h"
#include "tests/engine/study/in_memory.h"

namespace plumb {
namespace uncertainty_run_test {

/// A free cable that falls as −g t²/2, beside figures that are 0.01 m too high at the end.
CaseSource falling(const std::string& extra) {
  CaseSource source;
  source.file = {"falling.toml", R"(title = "falling"
[cable]
length = 1
area = 1e-4
density = 1000
youngs_modulus = 1e6
elements = 4
[loads]
gravity = [0, -10, 0]
[method]
name = "velocity-verlet"
step = 1e-3
[time]
end = 1.0
output_interval = 0.25
[[probe]]
name = "mid"
at = 0.5
quantity = "position"
[[reference]]
name = "book"
file = "book.toml"
compare = { y = "mid.y" }
tolerance = 0.1
)" + extra};
  source.references = {MadeReference{.rows = "[0.0, 0.0], [0.5, -1.25], [1.0, -5.01]",
                                     .file = "book.toml",
                                     .title = "book",
                                     .uncertainty = 0.003,
                                     .basis = "half a unit of the last printed digit"}
                           .text()};
  return source;
}

Run run_of(const CaseSource& source) {
  Run run;
  run.loaded = load_case(source);
  run.trajectory = integrate(run.loaded.spec);
  run.probes = probe(run.loaded.spec, run.trajectory);
  return run;
}

const std::string sampled = R"([uncertainty]
samples = 64
seed = 3
[[uncertainty.input]]
key = "loads.gravity.1"
spread = 0.02
relative = true
source = "a guess"
[[uncertainty.input]]
key = "cable.density"
distribution = "uniform"
spread = 100
source = "a guess"
)";

TEST(RunUncertainty, SamplingFindsTheSpreadOfALinearModel) {
  const Uncertainty found = run_uncertainty(run_of(falling(sampled)), InMemory());
  ASSERT_EQ(found.series.size(), 1U);
  const SeriesUncertainty& series = found.series[0];
  const UncertaintyPart& input = series.parts.at(3);
  ASSERT_EQ(input.state, PartState::estimated) << input.how;
  for (std::size_t k = 0; k < series.times.size(); ++k) {
    const double t = series.times[k];
    EXPECT_NEAR(input.values[k], 0.02 * 10 * t * t / 2, 0.02 * 0.1 * t * t) << "s g t²/2 at " << t;
  }
  EXPECT_EQ(found.sampling.completed, 64);
  EXPECT_EQ(found.runs, 3 + 1 + 64);
  EXPECT_EQ(series.greatest, 2U);
  EXPECT_NEAR(series.error[2], 0.01, 1e-9) << "E is run minus reference";
  EXPECT_EQ(series.parts[0].state, PartState::estimated) << series.parts[0].how;
  EXPECT_LT(series.parts[0].values[2], 1e-9) << "every mesh falls alike";
  EXPECT_EQ(series.parts[2].state, PartState::no_part) << series.parts[2].how;
  EXPECT_NEAR(series.parts[4].values[2], 0.003 / std::sqrt(3), 1e-12);
  EXPECT_EQ(series.finding, "not distinguishable at any of 3 times");
  EXPECT_EQ(series.share_within, 1);
}

TEST(RunUncertainty, HasNoPartInWhatTheReferenceShares) {
  const auto found = [](const std::string& shares) {
    CaseSource source = falling(sampled);
    source.references[0].text += "[shares]\n" + shares;
    return run_uncertainty(run_of(source), InMemory());
  };
  const SeriesUncertainty mesh = found("elements = 4").series.at(0);
  EXPECT_EQ(mesh.parts[0].state, PartState::no_part) << mesh.parts[0].how;
  EXPECT_EQ(mesh.parts[3].state, PartState::estimated);
  for (const char* other : {"elements = 8", "elements = 4\nstrain = \"engineering-material\""})
    EXPECT_EQ(found(other).series.at(0).parts[0].state, PartState::estimated) << other;

  const Uncertainty without_gravity = found("inputs = [\"loads.gravity.1\"]\nmodel = \"no air\"");
  const UncertaintyPart& input = without_gravity.series.at(0).parts.at(3);
  ASSERT_EQ(input.state, PartState::estimated) << input.how;
  EXPECT_LT(input.values.back(), 1e-9) << "it falls alike with any density";
  EXPECT_EQ(without_gravity.series[0].shared_model, "no air");
  EXPECT_EQ(without_gravity.sampling.completed, 64);
  EXPECT_EQ(found("inputs = [\"loads.gravity.1\", \"cable.density\"]").series.at(0).parts.at(3).state,
            PartState::no_part);
}

TEST(RunUncertainty, IsTheSameForTheSameSeed) {
  const auto values = [](const std::string& seed) {
    std::string text = sampled;
    text.replace(text.find("seed = 3"), 8, "seed = " + seed);
    return run_uncertainty(run_of(falling(text)), InMemory()).series.at(0).parts.at(3).values;
  };
  EXPECT_EQ(values("3"), values("3"));
  EXPECT_NE(values("3"), values("4"));
}

TEST(RunUncertainty, WhatIsNotAskedForIsNotEstimated) {
  const Uncertainty found =
      run_uncertainty(run_of(falling("[uncertainty]\nnumerical = false\n")), InMemory());
  const SeriesUncertainty& series = found.series.at(0);
  EXPECT_EQ(found.runs, 0);
  for (const std::size_t k : {0U, 1U, 3U}) {
    EXPECT_EQ(series.parts.at(k).state, PartState::not_estimated) << series.parts[k].name;
    EXPECT_TRUE(series.parts[k].values.empty());
    EXPECT_FALSE(series.parts[k].how.empty());
  }
  EXPECT_FALSE(series.whole());
  EXPECT_NEAR(series.validation[2], 0.003 / std::sqrt(3), 1e-12) << "of the data alone";
  EXPECT_EQ(series.finding,
            "distinguishable at 1 of 3 times, at 1 s: model error between 0.00654 and 0.0135 m at 1 s, or in "
            "wider bounds: not every part is estimated");
}

TEST(RunUncertainty, HasATimeBetweenOutputsOnlyWhereInterpolationCanBeTold) {
  const auto times = [](const std::string& interval) {
    CaseSource source = falling("[uncertainty]\nnumerical = false\n");
    source.overrides = {"time.output_interval=" + interval};
    return run_uncertainty(run_of(source), InMemory()).series.at(0).times;
  };
  EXPECT_EQ(times("0.15"), (std::vector<double>{0, 0.5, 1})) << "from eight outputs";
  EXPECT_EQ(times("0.17"), (std::vector<double>{0, 1})) << "seven are too few";
}

TEST(UncertaintyParts, InterpolationIsBoundsOfAUniformDistributionAndNoPartAtOutputs) {
  const UncertaintyPart between = interpolation_part({0, 0.003});
  EXPECT_EQ(between.state, PartState::estimated);
  EXPECT_EQ(between.values.at(0), 0);
  EXPECT_NEAR(between.values.at(1), 0.003 / std::sqrt(3), 1e-15);
  EXPECT_EQ(interpolation_part({0, 0}).state, PartState::no_part);
}

TEST(RunUncertainty, SamplesThatFailAreCountedAndNamed) {
  const Uncertainty found = run_uncertainty(run_of(falling(R"([uncertainty]
numerical = false
samples = 20
[[uncertainty.input]]
key = "cable.density"
spread = 1
relative = true
source = "nobody knows"
)")),
                                            InMemory());
  EXPECT_GT(found.sampling.failures.size(), 0U) << "some densities are below 0";
  EXPECT_EQ(found.sampling.completed + std::ssize(found.sampling.failures), 20);
  EXPECT_NE(found.sampling.failures.at(0).find("cable.density = -"), std::string::npos)
      << found.sampling.failures[0];
}

TEST(RunUncertainty, ARunThatDidNotCompleteHasNone) {
  plumb::Run run = run_of(falling("[uncertainty]\n"));
  run.trajectory.outcome = Outcome::diverged;
  const Uncertainty found = run_uncertainty(run, InMemory());
  EXPECT_TRUE(found.series.empty());
  EXPECT_EQ(found.left_out, std::vector<std::string>{"book: mid.y: the run did not complete"});
}

TEST(AssessmentFile, IsReadBackAsItWas) {
  const plumb::Run run = run_of(falling(sampled));
  Assessment assessment;
  assessment.uncertainty = run_uncertainty(run, InMemory());
  const std::string text = encode_assessment(assessment);
  EXPECT_EQ(encode_assessment(decode_assessment(text, "a.json", run)), text);
}

TEST(AssessmentFile, OfAnotherRunOrDamagedIsRefused) {
  const plumb::Run run = run_of(falling("[uncertainty]\nnumerical = false\n"));
  Assessment assessment;
  assessment.uncertainty = run_uncertainty(run, InMemory());
  const std::string text = encode_assessment(assessment);
  const auto refused = [&](const std::string& damaged, const plumb::Run& of) -> std::string {
    try {
      decode_assessment(damaged, "a.json", of);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string copy = text;
    const std::size_t at = copy.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return copy.replace(at, from.size(), to);
  };
  const plumb::Run heavier = run_of([] {
    CaseSource source = falling("");
    source.overrides = {"loads.gravity=[0, -11, 0]"};
    return source;
  }());
  for (const auto& [message, says] : std::vector<std::pair<std::string, std::string>>{
           {refused(text, heavier), "it is that of another run: book: mid.y differs from the reference by"},
           {refused(text.substr(0, text.size() / 2), run), ": is not JSON"},
           {refused(changed("assessment", "sweep"), run), "it is no assessment"},
           {refused(changed("\"version\": 2", "\"version\": 1"), run),
            "its version is 1, this program reads version 2"},
           {refused(changed("\"mid.y\"", "\"mid.x\""), run), "book: mid.x is not compared"},
           {refused(changed("not estimated", "not imagined"), run), "'not imagined' is no word for it"},
       })
    EXPECT_NE(message.find(says), std::string::npos) << message << "\n" << says;
}

}  // namespace uncertainty_run_test
}  // namespace plumb
