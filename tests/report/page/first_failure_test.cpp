#include "report/page/first_failure.h"

#include <gtest/gtest.h>

#include "render/image/apng.h"
#include "report/page/page_template.h"
#include "tests/report/made_run.h"

namespace plumb {
namespace first_failure_test {

/// One frame every tenth of a second, each of another colour.
struct MadeAnimation {
  std::vector<std::string> frames;
  Pictures pictures;

  MadeAnimation() {
    for (int k = 0; k <= 10; ++k)
      frames.push_back(encode_png({1, 1, {static_cast<std::uint8_t>(20 * k), 0, 0}}));
    pictures.frames = 11;
    pictures.player_frame_rate = 10;
    pictures.page_animation = join_apng(frames, 10);
  }
  std::string uri(std::size_t k) const {
    return data_uri(split_apng(pictures.page_animation, "a.png").at(k));
  }
};

Document failing(double tolerance = 0.05) {
  plumb::Run run = run_with("a");
  run.loaded.spec.references[0].tolerance = tolerance;
  return document_of(evaluate(run, {}), {});
}

TEST(FirstFailure, IsEmptyWhereNothingFailed) {
  EXPECT_EQ(first_failure_html(failing(0.125), MadeAnimation().pictures), "");
}

// The tip is 0.1 m off at 1 s.
TEST(FirstFailure, ShowsTheCriterionAndTheFrameOfItsTime) {
  const MadeAnimation made;
  Document document = failing();
  EXPECT_EQ(document["verdicts"][0]["time"], 1.0);
  const std::string html = first_failure_html(document, made.pictures);
  EXPECT_NE(html.find("known: tip.y"), html.npos) << html;
  EXPECT_NE(html.find("0.1 m found, 0.05 m allowed: 2 times as much."), html.npos) << html;
  EXPECT_NE(html.find(made.uri(10)), html.npos);
  document["verdicts"][0]["time"] = 0.34;
  const std::string earlier = first_failure_html(document, made.pictures);
  EXPECT_NE(earlier.find(made.uri(3)), html.npos);
  EXPECT_NE(earlier.find("The cable at 0.3 s, the frame next to 0.34 s."), html.npos) << earlier;
  EXPECT_EQ(html.find("the frame next to"), html.npos) << html;
  document["verdicts"][0]["time"] = -1;
  EXPECT_EQ(first_failure_html(document, made.pictures).find("<img"), html.npos) << "of no one time";
}

TEST(FirstFailure, PutsWhatMovedFirstAndThenWhatIsMissedByMost) {
  Document document = failing();
  Document worse = document["verdicts"][0], moved = worse;
  worse["name"] = "known: tip.z";
  worse["value"] = 5;
  moved["name"] = "baseline: tip.x";
  moved["kind"] = "regression";
  moved["unit"] = "1";
  document["verdicts"].push_back(worse);
  const auto first = [&] {
    const std::string html = first_failure_html(document, {});
    const std::size_t from = html.find("<strong>") + 8;
    return html.substr(from, html.find("</strong>") - from);
  };
  EXPECT_EQ(first(), "known: tip.z");
  document["verdicts"].push_back(moved);
  EXPECT_EQ(first(), "baseline: tip.x");
  EXPECT_NE(first_failure_html(document, {}).find("What moved"), std::string::npos);
  document["verdicts"][2]["status"] = "passed";
  document["verdicts"][0]["value"] = nullptr;
  EXPECT_EQ(first(), "known: tip.y") << "what is no number is worst";
}

TEST(FirstFailure, OfARunThatEndedShowsItsLastFrame) {
  plumb::Run run = run_with("a");
  run.trajectory.outcome = Outcome::unstable;
  run.trajectory.end_time = 0.5;
  const Document document = document_of(evaluate(run, {}), {});
  const MadeAnimation made;
  const std::string html = first_failure_html(document, made.pictures);
  EXPECT_NE(html.find("How it ended: unstable"), html.npos) << html;
  EXPECT_NE(html.find(made.uri(5)), html.npos);
  EXPECT_NE(html.find("broke off at 0.5 s; the picture is the last one of it, at 0.5 s."), html.npos) << html;
  run.trajectory.end_time = 0.04;
  const std::string start = first_failure_html(document_of(evaluate(run, {}), {}), made.pictures);
  EXPECT_NE(start.find("broke off at 0.04 s; the picture is the last one of it, at 0 s, its start."),
            html.npos)
      << start;
  EXPECT_EQ(first_failure_html(document, {}), "") << "the headline says the rest";
}

}  // namespace first_failure_test
}  // namespace plumb
