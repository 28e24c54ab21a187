#include <nlohmann/json.hpp>

#include "render/gl_context.h"
#include "render/plot_renderer.h"
#include "render/png.h"
#include "report/figure_csv.h"
#include "report/file_difference.h"
#include "report/number_difference.h"
#include "report/pictures.h"
#include "tests/report/program.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

/// A plot like those of reports: a curve and measured points.
Plot sample(double up = 0) {
  Plot plot;
  plot.width = 800;
  plot.height = 600;
  plot.font_size = 18;
  plot.title = "sample";
  Panel panel;
  panel.x.label = "time [s]";
  panel.y.label = "height [m]";
  panel.x.range = {0, 10};
  panel.y.range = {-2, 2};
  Series curve;
  curve.label = "curve";
  for (int i = 0; i <= 200; ++i) {
    curve.x.push_back(0.05 * i);
    curve.y.push_back(std::sin(0.05 * i) + up);
  }
  Series points;
  points.label = "points";
  points.x = {1, 3, 5, 7, 9};
  points.y = {0.5, 1.2, -0.4, 1.5, -1};
  points.line_width = 0;
  points.marker = Marker::circle;
  panel.series = {curve, points};
  plot.panels = {panel};
  return plot;
}

/// How many pixels one unit of y is high in the sample.
double pixels_a_unit(const GlContext& context) {
  Plot plot = sample();
  plot.panels[0].series.resize(1);
  plot.panels[0].legend = false;
  const auto row_of = [&](double y) {
    Series& line = plot.panels[0].series[0];
    line.x = {0, 10};
    line.y = {y, y};
    line.color = Color::hex(0xFF0000);
    line.line_width = 3;
    const Image image = PlotRenderer(context).draw(plot);
    for (int row = 0; row < image.height; ++row) {
      const auto i = static_cast<std::size_t>(3 * (row * image.width + image.width / 2));
      if (image.rgb[i] > 200 && image.rgb[i + 1] < 60 && image.rgb[i + 2] < 60) return row;
    }
    return -1;
  };
  return (row_of(-1) - row_of(1)) / 2.0;
}

std::string drawn(const GlContext& context, const Plot& plot, const std::string& renderer) {
  return encode_png(PlotRenderer(context).draw(plot), {{renderer_keyword, renderer}});
}

TEST(Diff, MutationsOfAFigureAreCaughtOrPassedAsStated) {
  const GlContext context;
  const double unit = pixels_a_unit(context);
  ASSERT_GT(unit, 50);
  const std::string baseline = drawn(context, sample(), "one");
  const auto verdicts = [&](const std::string& name, auto&& mutate, Sameness same_renderer, Sameness others) {
    SCOPED_TRACE(name);
    const std::string same = mutate("one"), other = mutate("other");
    const FileDifference strict = compare_files("a.png", baseline, same, {});
    const FileDifference loose = compare_files("a.png", baseline, other, {});
    EXPECT_EQ(word(strict.sameness), word(same_renderer)) << strict.in_words;
    EXPECT_EQ(word(loose.sameness), word(others)) << loose.in_words;
  };
  const auto plot_of = [&](auto change) {
    return [&context, change](const std::string& renderer) {
      Plot plot = sample();
      change(plot);
      return drawn(context, plot, renderer);
    };
  };
  verdicts("nothing", plot_of([](Plot&) {}), Sameness::identical, Sameness::identical);
  verdicts("curve up by 0.3 px", plot_of([&](Plot& plot) {
             for (double& y : plot.panels[0].series[0].y) y += 0.3 / unit;
           }),
           Sameness::different, Sameness::different);
  verdicts("curve up by 0.01 px", plot_of([&](Plot& plot) {
             for (double& y : plot.panels[0].series[0].y) y += 0.01 / unit;
           }),
           Sameness::different, Sameness::within);
  verdicts("a marker missing", plot_of([](Plot& plot) {
             plot.panels[0].series[1].x.pop_back();
             plot.panels[0].series[1].y.pop_back();
           }),
           Sameness::different, Sameness::different);
  verdicts("a tick label changed", plot_of([](Plot& plot) {
             plot.panels[0].x.ticks = {0, 2, 4, 6, 9};
           }),
           Sameness::different, Sameness::different);
  verdicts("a letter of the title", plot_of([](Plot& plot) { plot.title = "sampIe"; }), Sameness::different,
           Sameness::different);
  verdicts(
      "one level everywhere",
      [&](const std::string& renderer) {
        Image image = PlotRenderer(context).draw(sample());
        for (auto& level : image.rgb) level = static_cast<std::uint8_t>(level < 255 ? level + 1 : 254);
        return encode_png(image, {{renderer_keyword, renderer}});
      },
      Sameness::different, Sameness::within);
  verdicts("one column wider", plot_of([](Plot& plot) { plot.width = 801; }), Sameness::different,
           Sameness::different);
}

TEST(Diff, ACurveThatMovedByLessThanAPixelIsCaughtInItsNumbers) {
  const Plot before = sample(), after = sample(1e-7);
  const std::string a = to_csv(before), b = to_csv(after);
  EXPECT_EQ(compare_files("figures/a.csv", a, b, {}).sameness, Sameness::different);
  EXPECT_EQ(compare_files("figures/a.csv", a, b, {.channel = {}, .density = {}, .numbers = 1e-6}).sameness,
            Sameness::within);
  EXPECT_EQ(compare_files("figures/a.csv", a, a, {}).sameness, Sameness::identical);
}

TEST(Diff, NumbersAreHeldAgainstTheLargestOfTheirColumnAndKind) {
  const auto greatest = [](const std::string& a, const std::string& b) {
    const NumberDifference found = number_difference(a, "a", b, "b");
    return found.unlike.empty() ? found.greatest : -1;
  };
  EXPECT_DOUBLE_EQ(greatest("t,x\n0,4\n1,2\n", "t,x\n0,4\n1,3\n"), 0.25);
  EXPECT_DOUBLE_EQ(greatest("s,x\na,4\nb,0.2\n", "s,x\na,4\nb,0.1\n"), 0.5) << "b's own largest is 0.2";
  EXPECT_DOUBLE_EQ(greatest("x\n1\n", "x\n1.0\n"), 0);
  EXPECT_DOUBLE_EQ(greatest("x\nnan\n", "x\nnan\n"), 0);
  EXPECT_TRUE(std::isinf(greatest("x\nnan\n", "x\n1\n")));
  EXPECT_DOUBLE_EQ(greatest("x\n1\n", "x\n1\n2\n"), -1);
  EXPECT_DOUBLE_EQ(greatest("x\n1\n", "x\n1,2\n"), -1);
  EXPECT_DOUBLE_EQ(greatest("x\n1\n", "y\n1\n"), -1);
}

TEST(Diff, DamagedFilesAreUnreadableAndFail) {
  const GlContext context;
  const std::string png = drawn(context, sample(), "one");
  EXPECT_EQ(compare_files("a.png", png, png.substr(0, 100), {}).sameness, Sameness::unreadable);
  EXPECT_EQ(compare_files("a.csv", "x\n1\n", "x\n\"1\n", {}).sameness, Sameness::unreadable);
  EXPECT_EQ(compare_files("results.json", "{}", "{", {}).sameness, Sameness::unreadable);
  EXPECT_TRUE(fails(Sameness::unreadable));
}

TEST(Diff, VerdictsThatChangedAreDifferences) {
  const std::string before =
      R"({"outcome":"accurate","verdicts":[{"name":"a","status":"passed"}],"seconds":1})";
  const std::string after =
      R"({"outcome":"accurate","verdicts":[{"name":"a","status":"failed"}],"seconds":2})";
  const std::string later =
      R"({"outcome":"accurate","verdicts":[{"name":"a","status":"passed"}],"seconds":3})";
  EXPECT_EQ(compare_files("results.json", before, later, {}).sameness, Sameness::identical);
  const FileDifference found = compare_files("results.json", before, after, {});
  EXPECT_EQ(found.sameness, Sameness::different);
  EXPECT_NE(found.in_words.find("a: passed → failed"), std::string::npos) << found.in_words;
}

class DiffProgram : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder / "a/x.csv", "t,x\n0,1\n");
    write_text(folder / "a/run.h5", "first");
    write_text(folder / "b/x.csv", "t,x\n0,1\n");
    write_text(folder / "b/run.h5", "second");
  }
  Ended diff(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "diff");
    return plumb_in(folder.path(), arguments);
  }
  TemporaryFolder folder;
};

TEST_F(DiffProgram, FoldersWithTheSameResultsEndWithNought) {
  const Ended ended = diff({"a", "b"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("None of 1 files differs"), std::string::npos) << ended.out;
}

TEST_F(DiffProgram, MissingAndNewFilesAreDifferences) {
  write_text(folder / "a/gone.csv", "x\n1\n");
  write_text(folder / "b/frames/0000.png", "no picture");
  const Ended ended = diff({"a", "b", "--json"});
  EXPECT_EQ(ended.status, 1);
  const Json json = Json::parse(ended.out);
  EXPECT_TRUE(json["different"]);
  std::map<std::string, std::string> results;
  for (const Json& file : json["files"]) results[file["name"]] = file["result"];
  EXPECT_EQ(results["gone.csv"], "missing");
  EXPECT_EQ(results["frames/0000.png"], "new");
  EXPECT_EQ(results["run.h5"], "not compared");
}

TEST_F(DiffProgram, AcceptReplacesTheBaselineAndSaysSo) {
  write_text(folder / "b/x.csv", "t,x\n0,2\n");
  EXPECT_EQ(diff({"a", "b"}).status, 1);
  EXPECT_EQ(read_text(folder / "a/x.csv"), "t,x\n0,1\n") << "nothing changes without --accept";
  const Ended ended = diff({"a", "b", "--accept"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("accepted"), std::string::npos) << ended.out;
  EXPECT_EQ(read_text(folder / "a/x.csv"), "t,x\n0,2\n");
  EXPECT_EQ(read_text(folder / "b/x.csv"), "t,x\n0,2\n") << "the new one stays";
  EXPECT_NE(diff({"a", "b", "--accept"}).out.find("nothing to accept"), std::string::npos);
  const Ended first = diff({"new.csv", "b/x.csv", "--accept"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(read_text(folder / "new.csv"), "t,x\n0,2\n");
}

TEST_F(DiffProgram, AcceptLeavesAFolderAloneThatIsNoOutput) {
  write_text(folder / "precious/x.csv", "mine");
  const Ended ended = diff({"precious", "b", "--accept"});
  EXPECT_EQ(ended.status, 5);
  expect_one_line(ended.err);
  EXPECT_EQ(read_text(folder / "precious/x.csv"), "mine");
}

TEST_F(DiffProgram, BadArgumentsAndFilesAreRefusedInOneLine) {
  write_text(folder / "a.txt", "1");
  write_text(folder / "b.txt", "2");
  for (const auto& [arguments, status] : {std::pair<std::vector<std::string>, int>{{"a"}, 2},
                                          {{"a", "b", "--channel", "256"}, 2},
                                          {{"a", "b", "--channel", "x"}, 2},
                                          {{"a", "b", "--density", "1.5"}, 2},
                                          {{"a", "b", "--numbers", "-1"}, 2},
                                          {{"a", "nothing"}, 3},
                                          {{"a", "a.txt"}, 3},
                                          {{"a.txt", "b.txt"}, 3},
                                          {{"a", "b", "--html", "no/such/folder/page.html"}, 5}}) {
    const Ended ended = diff(arguments);
    EXPECT_EQ(ended.status, status) << testing::PrintToString(arguments) << ended.err;
    expect_one_line(ended.err);
  }
}

TEST_F(DiffProgram, PageShowsBothPicturesAndTheMarks) {
  const GlContext context;
  write_text(folder / "a.png", drawn(context, sample(), "one"));
  write_text(folder / "b.png", drawn(context, sample(0.2), "one"));
  const Ended ended = diff({"a.png", "b.png", "--html", "page.html"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const std::string page = read_text(folder / "page.html");
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("data:image/png", at)) != std::string::npos; ++at) ++pictures;
  EXPECT_EQ(pictures, 3U);
  EXPECT_EQ(page.find("http://"), std::string::npos);
}

}  // namespace
}  // namespace plumb
