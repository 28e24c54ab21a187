#include "report/conclusion.h"

#include <gtest/gtest.h>

#include "report/reproduce.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace conclusion_test {

Conclusion conclusion(const plumb::Run& run) {
  return conclusion_of(document_of(evaluate(run, {}), {}));
}

TEST(Conclusion, SaysHowFarARunAgreesOrWhatItMisses) {
  plumb::Run run = run_with("a");
  EXPECT_EQ(conclusion(run).sentence, "The 1-element run agrees with the published figures to 0.1 m.");
  EXPECT_TRUE(conclusion(run).good);
  run.loaded.spec.references[0].tolerance = 0.05;
  EXPECT_EQ(conclusion(run).sentence,
            "1 of 1 criterion not met: the 1-element run is 0.1 m from the published figures (tip.y, where "
            "0.05 m is allowed).");
  EXPECT_FALSE(conclusion(run).good);
}

TEST(Conclusion, ClaimsNothingOfARunThatWasNotCompared) {
  plumb::Run run = run_with("a");
  run.loaded.references[0].cable.length = 3;
  EXPECT_EQ(conclusion(run).sentence,
            "The 1-element run completed, but none of 1 criterion could be judged.");
  run.loaded.references.clear();
  run.loaded.spec.references.clear();
  EXPECT_EQ(conclusion(run).sentence,
            "The 1-element run completed and was held against nothing: how accurate it is cannot be told.");
  EXPECT_FALSE(conclusion(run).good);
}

TEST(Conclusion, OfAFailedRunIsWhatWentWrongAndWhatWouldHelp) {
  plumb::Run run = run_with("a");
  run.trajectory.outcome = Outcome::unstable;
  run.trajectory.message = "it grew; what would help: a shorter step";
  const Conclusion found = conclusion(run);
  EXPECT_EQ(
      found.sentence,
      "The 1-element run failed: it is unstable and ended at 1 s of 1 s, so its one criterion could not "
      "be judged.");
  EXPECT_EQ(found.trouble, "it grew");
  EXPECT_EQ(found.help, "a shorter step");
  EXPECT_FALSE(found.good);
}

TEST(Reproduce, QuotesWhatAShellWouldActOn) {
  EXPECT_EQ(shell_word("cable.elements=1"), "cable.elements=1");
  EXPECT_EQ(shell_word("a b"), "'a b'");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace conclusion_test
}  // namespace plumb
