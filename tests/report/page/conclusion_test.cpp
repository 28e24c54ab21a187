#include "report/page/conclusion.h"

#include <gtest/gtest.h>

#include "report/page/reproduce.h"
#include "report/study/work_precision/work_precision_page.h"
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

TEST(Conclusion, IsOfTheVerdictThatUsesMostOfWhatItIsAllowed) {
  Document document = document_of(evaluate(run_with("a"), {}), {});
  Document wide = document["verdicts"][0];
  wide["name"] = "known: tip.x";
  wide["value"] = 0.2;
  wide["limit"] = 1;
  document["verdicts"].insert(document["verdicts"].begin(), wide);
  EXPECT_EQ(conclusion_of(document).sentence,
            "The 1-element run agrees with the published figures to 0.1 m.");
}

TEST(Conclusion, JoinsTheLastOfSeveralReferencesByAnd) {
  Document document = document_of(evaluate(run_with("a"), {}), {});
  for (const char* name : {"second", "third"}) {
    for (const char* list : {"references", "verdicts"}) document[list].push_back(document[list][0]);
    document["references"].back()["name"] = name;
    document["verdicts"].back()["name"] = std::string(name) + ": tip.y";
  }
  EXPECT_EQ(
      conclusion_of(document).sentence,
      "The 1-element run agrees with the published figures “known” to 0.1 m, with the published figures "
      "“second” to 0.1 m and with the published figures “third” to 0.1 m.");
}

TEST(Conclusion, OfWhatIsNoReferenceIsWhetherItIsMet) {
  Document document = document_of(evaluate(run_with("a"), {}), {});
  document["verdicts"][0]["name"] = "energy";
  EXPECT_EQ(conclusion_of(document).sentence,
            "The 1-element run completed, and what it was held against is met.");
  document["verdicts"][0]["status"] = "failed";
  EXPECT_EQ(conclusion_of(document).sentence, "1 of 1 criterion not met: the 1-element run completed.");
}

TEST(Conclusion, SaysHowFarTheMeshIsFromTheFinestWhereThatIsKnown) {
  Document document = document_of(evaluate(run_with("a"), {}), {});
  const std::string plain = "The 1-element run agrees with the published figures to 0.1 m.";
  const auto details = [&](const Document& distance) {
    document["work_precision"] = {{"end", 1.0}, {"mesh", {{"elements", {1, 2}}}}};
    document["work_precision"]["mesh"]["distance"] = Document::array({distance, nullptr});
    const Conclusion found = conclusion_of(document, {mesh_clause(document)});
    EXPECT_EQ(found.sentence, plain);
    return found.details;
  };
  EXPECT_EQ(details(0.5), "The mesh itself is 0.5 m from that of 2 elements over 1 s.");
  EXPECT_EQ(details(0.0), "") << "that is no distance";
  EXPECT_EQ(details(nullptr), "");
}

TEST(Reproduce, QuotesWhatAShellWouldActOn) {
  EXPECT_EQ(shell_word("cable.elements=1"), "cable.elements=1");
  EXPECT_EQ(shell_word("a b"), "'a b'");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace conclusion_test
}  // namespace plumb
