#include "engine/study/economy/model_selection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/study/economy/candidates.h"
#include "engine/study/economy/economy_json.h"
#include "engine/study/economy/economy_scenes.h"
#include "tests/engine/pendulum.h"
#include "tests/engine/small_case.h"
#include "tests/engine/study/economy/tips_along_z.h"

namespace plumb {
namespace choose_candidate_test {

Case scene_of(double end, double tolerance) {
  Case spec = pendulum(5, 4);
  spec.method.name = scene_method;
  spec.time = {end, 0.04};
  spec.scene.tolerance = tolerance;
  return spec;
}

/// The truth: twice as fine as anything that the tests choose.
double true_error(const Case& spec, const Candidate& candidate, const MakeGauge& gauge) {
  Candidate fine = cable_candidate(spec, 32);
  fine.method = plain_method(*find_method("rk4"));
  fine.method.step = *cable_candidate(spec, 32).method.step;
  const Trajectory truth = integrate(with_candidate(spec, fine));
  const std::vector<double> errors = gauge(truth)(integrate(with_candidate(spec, candidate)));
  return *std::max_element(errors.begin(), errors.end());
}

TEST(ChooseCandidate, TakesFinerCandidatesForFinerPicturesAndMeetsTheToleranceWithEach) {
  const Case spec = scene_of(0.6, 0.5);
  double work = 0;
  for (const double pixels_per_metre : {50.0, 400.0, 3000.0}) {
    const MakeGauge gauge = tips_along_z(pixels_per_metre, 25);
    const Economy economy = choose_candidate(spec, gauge);
    ASSERT_TRUE(economy.holds) << economy.uncertain;
    const TriedCandidate& choice = *economy.choice();
    const double error = true_error(spec, choice.candidate, gauge);
    EXPECT_LE(error, 0.5) << in_words(choice.candidate);
    EXPECT_LE(error, economy_safety * choice.estimate) << in_words(choice.candidate);
    EXPECT_GE(choice.candidate.work, work) << in_words(choice.candidate);
    EXPECT_LT(economy.search_work, economy.safe_work);
    work = choice.candidate.work;
  }
}

// Meshes agree on it to the bit, and all of them are wrong.
TEST(ChooseCandidate, ProvesNothingOfACableThatStaysUprightForWantOfADisturbance) {
  Case spec = scene_of(1, 0.5);
  spec.start.direction = {0, 1, 0};
  spec.start.angular_velocity.setZero();
  const Economy economy = choose_candidate(spec, tips_along_z(400, 25));
  EXPECT_FALSE(economy.holds) << in_words(economy.choice()->candidate);
  EXPECT_NE(economy.uncertain.find("unstable start"), economy.uncertain.npos) << economy.uncertain;
}

TEST(ChooseCandidate, TakesTheCheapestThatHoldsOfAllThatItTried) {
  const Economy economy = choose_candidate(scene_of(0.6, 0.5), tips_along_z(400, 25));
  for (int k = 0; k < economy.chosen; ++k) {
    const TriedCandidate& cheaper = economy.tried[static_cast<std::size_t>(k)];
    EXPECT_LE(cheaper.candidate.work, economy.choice()->candidate.work);
    EXPECT_TRUE(cheaper.why.starts_with("left: ")) << cheaper.why;
    if (cheaper.estimate >= 0) {
      EXPECT_GT(economy_safety * cheaper.estimate, 0.5) << in_words(cheaper.candidate);
    }
  }
}

TEST(ChooseCandidate, ChoosesTheSameEveryTime) {
  const Case spec = scene_of(0.4, 0.5);
  const Economy a = choose_candidate(spec, tips_along_z(400, 25)),
                b = choose_candidate(spec, tips_along_z(400, 25));
  ASSERT_EQ(a.tried.size(), b.tried.size());
  EXPECT_EQ(a.chosen, b.chosen);
  for (std::size_t k = 0; k < a.tried.size(); ++k) {
    EXPECT_EQ(in_words(a.tried[k].candidate), in_words(b.tried[k].candidate));
    EXPECT_EQ(a.tried[k].estimate, b.tried[k].estimate);
  }
}

TEST(ChooseCandidate, TakesTheRigidRodWhereTheCableHardlyBends) {
  Case spec = scene_of(0.4, 0.5);
  spec.cable.youngs_modulus = 1e9;
  spec.cable.second_moment = 1e-8;
  const Economy economy = choose_candidate(spec, tips_along_z(300, 25));
  ASSERT_TRUE(economy.holds) << economy.uncertain;
  EXPECT_EQ(economy.choice()->candidate.cable.model, CableModel::rigid)
      << in_words(economy.choice()->candidate);
  EXPECT_EQ(economy.chosen, 0);
}

TEST(ChooseCandidate, TakesNoRodWhereThereIsNone) {
  Case spec = scene_of(0.2, 50);
  for (Support& end : {std::ref(spec.supports.last), std::ref(spec.supports.first)}) {
    end = Support::clamped;
    for (const Candidate& candidate : all_candidates(spec, 1e12))
      EXPECT_NE(candidate.cable.model, CableModel::rigid);
  }
}

TEST(ChooseCandidate, SaysWhatIsUncertainWhereNothingHolds) {
  const Economy economy = choose_candidate(scene_of(0.3, 1e-9), tips_along_z(4000, 25));
  EXPECT_FALSE(economy.holds);
  ASSERT_NE(economy.choice(), nullptr);
  EXPECT_NE(economy.uncertain.find("where the cable is"), std::string::npos) << economy.uncertain;
  EXPECT_LE(economy.search_work, economy.safe_work);
}

TEST(ChooseCandidate, ACameraThatNeverSeesTheCableProvesNothing) {
  const MakeGauge blind = [](const Trajectory&) {
    return [](const Trajectory&) { return std::vector<double>(); };
  };
  const Economy economy = choose_candidate(scene_of(0.3, 0.5), blind);
  EXPECT_FALSE(economy.holds);
  EXPECT_EQ(economy.choice()->candidate.cable.elements, safe_elements);
  EXPECT_NE(economy.uncertain.find("never in it"), std::string::npos) << economy.uncertain;
}

TEST(ChooseCandidate, StopsAtTheHorizonBeforeItSearches) {
  Case spec = scene_of(100, 0.5);
  spec.cable = pendulum(14, 4).cable;
  const Economy economy = choose_candidate(spec, tips_along_z(400, 25));
  EXPECT_FALSE(economy.holds);
  EXPECT_NE(economy.uncertain.find("horizon"), std::string::npos) << economy.uncertain;
  EXPECT_EQ(economy.tried.size(), 1U);
  EXPECT_LT(economy.search_work, 0.2 * economy.safe_work);
}

TEST(ChooseCandidate, KnowsWhatTheSafeRunCosts) {
  for (const double f : {4.0, 8.0}) {
    Case spec = scene_of(0.4, 0.5);
    spec.cable = pendulum(f, 4).cable;
    const Candidate safe = safe_candidate(spec);
    const Counters counted = integrate(with_candidate(spec, safe)).counters;
    Case half = spec;
    half.time.end = 0.2;
    const double work = safe_work(spec);
    const double a_step = work / static_cast<double>(counted.steps + counted.rejected_steps);
    EXPECT_NEAR(safe_work(half), work / 2, 0.2 * work) << "f = " << f;
    EXPECT_GT(a_step, 0.5 * 38800) << "f = " << f << ": fewer steps were predicted than were taken";
    EXPECT_LT(a_step, 2 * 38800) << "f = " << f << ": more steps were predicted than were taken";
  }
}

TEST(ChooseCandidate, RefusesWhatDoesNotMoveOrIsNoCable) {
  Case spec = scene_of(0.3, 0.5);
  spec.method.name = "statics";
  EXPECT_THROW(choose_candidate(spec, tips_along_z(100, 25)), InputError);
  spec = scene_of(0.3, 0.5);
  spec.cable.model = CableModel::chain;
  EXPECT_THROW(choose_candidate(spec, tips_along_z(100, 25)), InputError);
}

TEST(ChooseCandidate, OutputsAreWhereFramesAreAndWhereReferencesNeedThem) {
  Case spec = scene_of(1, 0.5);
  spec.time.output_interval = 0.01;
  EXPECT_EQ(scene_output_interval(spec), 0.04);
  spec.figures.emplace_back();
  EXPECT_NEAR(scene_output_interval(spec), 0.01, 1e-15);
  spec.time.output_interval = 0.03;
  EXPECT_NEAR(scene_output_interval(spec), 0.02, 1e-15);
}

TEST(ChooseCandidate, TheOverridesOfARungMakeItOfTheFile) {
  const LoadedCase loaded = load_case(small_case());
  for (const Candidate& candidate : all_candidates(loaded.spec, 1e9)) {
    CaseSource source = small_case();
    for (const std::string& text : candidate_overrides(loaded.spec, candidate))
      source.overrides.push_back(text);
    const Case made = load_case(source).spec, meant = with_candidate(loaded.spec, candidate);
    EXPECT_EQ(made.method, meant.method) << in_words(candidate);
    EXPECT_EQ(made.cable.elements, meant.cable.elements);
    EXPECT_EQ(made.cable.model, meant.cable.model);
    EXPECT_EQ(made.cable.second_moment, meant.cable.second_moment);
    EXPECT_EQ(made.time.output_interval, outputs_of_a_frame * meant.time.output_interval);
  }
}

TEST(Choice, IsReadBackForTheSameCaseAndNoOther) {
  const Economy economy = choose_candidate(scene_of(0.2, 0.5), tips_along_z(400, 25));
  const CaseSource source = small_case();
  CaseSource made = source;
  made.overrides = {"cable.elements=3"};
  const std::string text = encode_choice(economy, choice_key(source), made);
  const std::optional<Economy> again = decode_choice(text, choice_key(source));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->chosen, economy.chosen);
  EXPECT_EQ(again->choice()->candidate.cable, economy.choice()->candidate.cable);
  EXPECT_EQ(again->choice()->candidate.method, economy.choice()->candidate.method);
  EXPECT_EQ(to_stored(*again), to_stored(economy));
  EXPECT_TRUE(decode_choice_made(text, made).has_value());
  EXPECT_FALSE(decode_choice_made(text, source).has_value());
  EXPECT_FALSE(decode_choice(text, choice_key(made)).has_value());
  CaseSource other = source;
  other.file.text += "\n";
  EXPECT_FALSE(decode_choice(text, choice_key(other)).has_value()) << "the text is another";
  EXPECT_FALSE(decode_choice(text.substr(0, text.size() / 2), choice_key(source)).has_value());
  EXPECT_FALSE(decode_choice("{}", choice_key(source)).has_value());
}

TEST(RandomScenes, DependOnTheSeedAndTheirNumberAlone) {
  const Case spec = load_case(small_case()).spec;
  EXPECT_EQ(scene_overrides(spec, 1, 7), scene_overrides(spec, 1, 7));
  EXPECT_NE(scene_overrides(spec, 1, 7), scene_overrides(spec, 1, 8));
  EXPECT_NE(scene_overrides(spec, 1, 7), scene_overrides(spec, 2, 7));
}

}  // namespace choose_candidate_test
}  // namespace plumb
