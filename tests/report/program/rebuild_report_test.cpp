#include "report/program/rebuild_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "render/image/png.h"
#include "report/page/page.h"
#include "tests/engine/study/changed_json.h"
#include "tests/render/image/made_png.h"
#include "tests/report/made_run.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace from_document_test {

class FromDocument : public testing::Test {
 protected:
  FromDocument() : good_(document_of(evaluate(run_with("a"), {}), {})) {}

  /// Makes a report of a document; empty, or why it was refused.
  std::string refusal(const Document& document) { return refusal_of_text(to_json(document)); }

  std::string refusal_of_text(const std::string& text) {
    write_text(folder_ / "run/results.json", text);
    Options options;
    options.from = (folder_ / "run/results.json").string();
    options.output = (folder_ / "made").string();
    Console console(false, true);
    try {
      report_from_document(options, console);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  /// With one figure of this name.
  Document with_figure(const std::string& file) const {
    Document document = good_;
    document["figures"] = {
        {{"file", file}, {"title", "t"}, {"alt", "a"}, {"tall", false}, {"panels", Document::array()}}};
    return document;
  }

  std::string page() { return read_text(folder_ / "made/index.html"); }

  TemporaryFolder folder_;
  Document good_;
};

TEST_F(FromDocument, PicturesAreTakenFromItsOwnFolderAlone) {
  const std::string png = encode_png({1, 1, {1, 2, 3}});
  write_text(folder_ / "run/figures/a.png", png);
  write_text(folder_ / "run/figures/text.png", "secret");
  write_text(folder_ / "outside.png", png);
  EXPECT_EQ(refusal(with_figure("figures/a.png")), "");
  EXPECT_NE(page().find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(refusal(with_figure("figures/../figures/./a.png")), "");
  fs::create_symlink("a.png", folder_ / "run/figures/within.png");
  EXPECT_EQ(refusal(with_figure("figures/within.png")), "");
  fs::create_symlink(folder_ / "outside.png", folder_ / "run/figures/out.png");
  fs::create_directory_symlink(folder_.path(), folder_ / "run/up");
  fs::create_symlink("/etc/passwd", folder_ / "run/figures/passwd.png");
  for (const std::string& file : std::vector<std::string>{
           "/etc/passwd", (folder_ / "outside.png").string(), "../outside.png", "figures/../../outside.png",
           "..", ".", "", "figures", "figures/out.png", "up/outside.png", "figures/passwd.png",
           "figures/text.png", "results.json", "nothing.png", "/dev/zero",
           std::string("figures/a.png\0.txt", 17), std::string(5000, 'x')}) {
    fs::remove_all(folder_ / "made");
    const std::string why = refusal(with_figure(file));
    EXPECT_FALSE(why.empty()) << file;
    EXPECT_EQ(why.find("secret"), std::string::npos) << why;
    EXPECT_EQ(why.find("root:"), std::string::npos) << why;
    EXPECT_FALSE(fs::exists(folder_ / "made")) << "nothing is written of what is refused: " << file;
  }
}

TEST_F(FromDocument, AnAnimationWithoutFramesIsRefused) {
  Document document = good_;
  document["animation"]["frames"] = 2;
  write_text(folder_ / "run/player.png", encode_png({1, 1, {1, 2, 3}}));
  EXPECT_EQ(refusal(document), "") << "a still picture";
  const std::string empty = file_of(
      {{"IHDR", header_of(1, 1)}, {"acTL", animation_of(1)}, {"IDAT", flat_data(1, 1, "abc")}, {"IEND", ""}});
  write_text(folder_ / "run/player.png", empty);
  const std::string why = refusal(document);
  EXPECT_NE(why.find("no frames"), std::string::npos) << why;
}

TEST_F(FromDocument, NothingOfWhatIsNoDocumentIsShown) {
  for (const std::string text :
       {"root:x:0:0:secret", "{\"secret\":1}", "[\"secret\"]", "{\"schema_version\":\"secret\"}",
        "{\"schema_version\":1,\"title\":\"secret\"}"}) {
    const std::string why = refusal_of_text(text);
    EXPECT_FALSE(why.empty());
    EXPECT_EQ(why.find("secret"), std::string::npos) << why;
    EXPECT_EQ(why.find("json.exception"), std::string::npos) << why;
  }
}

TEST_F(FromDocument, ClaimingMoreThanItsVerdictsIsRefused) {
  Document document = good_;
  ASSERT_FALSE(document["verdicts"].empty());
  document["all_criteria_met"] = true;
  document["verdicts"][0]["status"] = "passed";
  EXPECT_EQ(refusal(document), "");
  for (const char* status : {"failed", "not run"}) {
    document["verdicts"][0]["status"] = status;
    EXPECT_NE(refusal(document).find("which its verdicts do not"), std::string::npos) << status;
  }
  document["verdicts"][0]["status"] = "passed";
  document["complete"] = false;
  EXPECT_NE(refusal(document).find("which its verdicts do not"), std::string::npos);
  document["complete"] = true;
  for (const double value : {1e9, -1.0}) {
    document["verdicts"][0]["value"] = value;
    EXPECT_NE(refusal(document).find("is passed, which its numbers do not say"), std::string::npos) << value;
  }
  for (const bool met : {true, false}) {
    document["verdicts"] = Document::array();
    document["all_criteria_met"] = met;
    document["headline"] = met ? "Completed." : "Accurate. All criteria are met.";
    EXPECT_NE(refusal(document).find("which its verdicts do not"), std::string::npos) << met;
  }
}

TEST_F(FromDocument, WhatMovedSinceABaselineMakesARunNoLessAccurate) {
  Document document = good_;
  document["verdicts"][0]["status"] = "passed";
  Document moved = document["verdicts"][0];
  moved["kind"] = "regression";
  moved["name"] = "baseline: tip.y";
  moved["status"] = "failed";
  document["verdicts"].push_back(moved);
  document["outcome"] = "accurate";
  document["headline"] = "Accurate. Since the baseline 1 of 1 criteria of regression are not met.";
  document["all_criteria_met"] = false;
  EXPECT_EQ(refusal(document), "");
  document["all_criteria_met"] = true;
  EXPECT_NE(refusal(document).find("which its verdicts do not"), std::string::npos);
  document["all_criteria_met"] = false;
  document["verdicts"].erase(0);
  EXPECT_NE(refusal(document).find("which its verdicts do not"), std::string::npos)
      << "nothing is accurate by regression alone";
}

TEST_F(FromDocument, AnyValueThatWasChangedIsReadOrRefusedInWords) {
  expect_changes_read_or_refused(good_, 300, [&](const Document& changed) { return refusal(changed); });
}

}  // namespace from_document_test
}  // namespace plumb
