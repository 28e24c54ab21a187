#include "report/index/comparisons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "report/verdict/results.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace comparisons_test {

Document comparison(double reference, double predicted, double uncertainty = 0,
                    const std::string& kind = "validation") {
  Document one{{"kind", kind}, {"uncertainty", uncertainty}};
  one["greatest"] = {{"at", 1}, {"reference", reference}, {"predicted", predicted}};
  return one;
}

TEST(Comparisons, BiasAndSpreadOfAThousandAreThoseTheyWereMadeWith) {
  constexpr double bias = 1.07, spread = 0.05, of_reference = 0.03;
  std::mt19937_64 random(20);
  std::normal_distribution<double> normal;
  Document all = Document::array();
  for (int k = 0; k < 1000; ++k) {
    const double truth = (k % 3 == 0 ? -1 : 1) * std::pow(10.0, k % 7 - 3);
    const double measured = truth * (1 + of_reference * normal(random)),
                 predicted = bias * truth * (1 + spread * normal(random));
    all.push_back(comparison(measured, predicted, of_reference * std::sqrt(3) * std::abs(truth)));
  }
  const Document found = statistics_of(all);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at("comparisons"), 1000);
  EXPECT_EQ(found[0].at("left_out"), 0);
  // Three standard deviations of a mean and of a standard deviation of so many.
  EXPECT_NEAR(found[0].at("bias").get<double>(), bias, 3 * 0.0583 / std::sqrt(1000.0) * bias);
  EXPECT_NEAR(found[0].at("spread").get<double>(), spread, 3 * 0.0583 * 0.0583 / spread / std::sqrt(2000.0));
  EXPECT_NEAR(found[0].at("reference_spread").get<double>(), of_reference, 0.002);
  EXPECT_FALSE(found[0].at("reference_spread_is_bound").get<bool>());
}

TEST(Comparisons, StatisticsOfTwoPairsAreThoseByHand) {
  const double a = 0.02, u = 0.003;
  const Document found = statistics_of({comparison(10, 10 * std::exp(0.1 + a), u * 10 * std::numbers::sqrt3),
                                        comparison(-2, -2 * std::exp(0.1 - a), u * 2 * std::numbers::sqrt3)});
  const double variance = 2 * a * a, of_model = variance - u * u;
  EXPECT_NEAR(found[0].at("spread").get<double>(), std::sqrt(of_model), 1e-12);
  EXPECT_NEAR(found[0].at("bias").get<double>(), std::exp(0.1 + of_model / 2 - u * u / 2), 1e-12);
}

TEST(Comparisons, NoMoreThanHalfTheVarianceIsTakenForThatOfTheReferences) {
  const Document found = statistics_of({comparison(1, std::exp(0.01), 1), comparison(1, std::exp(-0.01), 1)});
  EXPECT_TRUE(found[0].at("reference_spread_is_bound").get<bool>());
  EXPECT_NEAR(found[0].at("spread").get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(found[0].at("reference_spread").get<double>(), 0.01, 1e-12);
}

TEST(Comparisons, PairsWithoutARatioAreCountedAndLeftOut) {
  Document null = comparison(1, 1);
  null["greatest"]["predicted"] = nullptr;
  const Document found = statistics_of({comparison(1, -1), comparison(0, 1), comparison(1, 0), null,
                                        comparison(1e-300, 1e300), comparison(2, 2), comparison(4, 4)});
  EXPECT_EQ(found[0].at("comparisons"), 7);
  EXPECT_EQ(found[0].at("left_out"), 5);
  EXPECT_EQ(found[0].at("bias"), 1.0);
  EXPECT_EQ(found[0].at("spread"), 0.0);
}

TEST(Comparisons, OfOnePairThereIsNoSpread) {
  const Document found = statistics_of(Document::array({comparison(2, 3)}));
  EXPECT_NEAR(found[0].at("bias").get<double>(), 1.5, 1e-15);
  EXPECT_TRUE(found[0].at("spread").is_null()) << found;
}

TEST(Comparisons, KindsAreApartAndThoseWithoutAPairAreNotThere) {
  const Document found =
      statistics_of({comparison(1, 1.1, 0, "verification"), comparison(1, 2, 0, "another model"),
                     comparison(1, 1.3, 0, "verification")});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].at("kind"), "verification");
  EXPECT_EQ(found[0].at("comparisons"), 2);
  EXPECT_EQ(found[1].at("kind"), "another model");
}

TEST(Comparisons, OfARunAreWhereTheReferenceAndWhereTheErrorIsGreatest) {
  const Document document = document_of(evaluate(run_with("made"), {}), {});
  const Document found = comparisons_of(document, "here");
  ASSERT_EQ(found.size(), 1U);
  // The tip falls as −t², and the reference ends at −0.9.
  EXPECT_EQ(found[0].at("name"), "known: tip.y");
  EXPECT_EQ(found[0].at("folder"), "here");
  for (const char* which : {"greatest", "farthest"}) {
    EXPECT_EQ(found[0].at(which).at("at"), 1.0) << which;
    EXPECT_EQ(found[0].at(which).at("reference"), -0.9);
    EXPECT_NEAR(found[0].at(which).at("predicted").get<double>(), -1, 1e-12);
  }
}

TEST(Comparisons, TheStartIsNoPrediction) {
  Document document = document_of(evaluate(run_with("made"), {}), {});
  Document& error = document["errors"][0];
  error["expected"][0] = -7.0;
  error["difference"][0] = 5.0;
  const Document found = comparisons_of(document, "here");
  EXPECT_EQ(found[0].at("greatest").at("at"), 1.0);
  EXPECT_EQ(found[0].at("farthest").at("at"), 1.0);
}

TEST(Comparisons, ThatWithExactFiguresHasTheVerdictOnThese) {
  Document document = document_of(evaluate(run_with("made"), {}), {});
  Document exact = document["verdicts"][0];
  exact["name"] = "known: exact: tip.y";
  exact["kind"] = "verification";
  document["verdicts"].push_back(exact);
  document["errors"].push_back(document["errors"][0]);
  document["errors"][1]["against"] = "exact";
  const Document found = comparisons_of(document, "here");
  EXPECT_EQ(found[0].at("name"), "known: tip.y");
  EXPECT_EQ(found[0].at("kind"), "validation");
  EXPECT_EQ(found[1].at("name"), "known: exact: tip.y");
  EXPECT_EQ(found[1].at("kind"), "verification");
}

TEST(Comparisons, AVerdictOfAnotherModelIsAKindOfItsOwn) {
  Document document = document_of(evaluate(run_with("made"), {}), {});
  document["verdicts"][0]["status"] = "another model";
  EXPECT_EQ(comparisons_of(document, "here")[0].at("kind"), "another model");
}

}  // namespace comparisons_test
}  // namespace plumb
