#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "engine/base/part_folder.h"
#include "render/gl/gl_context.h"
#include "render/image/png.h"
#include "render/plot/plot_renderer.h"
#include "report/diff/file_difference.h"
#include "report/diff/number_difference.h"
#include "report/figure/figure_csv.h"
#include "report/figure/pictures.h"
#include "tests/render/image/made_png.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace diff_test {

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

TEST(Diff, NumbersThatAreNotFiniteOrNotThereAreNeverWithinATolerance) {
  const DifferenceOptions anything{.channel = {}, .density = {}, .numbers = HUGE_VAL};
  const auto result = [&](const std::string& a, const std::string& b) {
    const FileDifference found = compare_files("a.csv", a, b, anything);
    return word(found.sameness) + (found.sameness == Sameness::different ? "" : ": " + found.in_words);
  };
  for (const auto& [a, b] : {std::pair{"nan", "1"},
                             {"1", "nan"},
                             {"inf", "1"},
                             {"inf", "-inf"},
                             {"nan", "inf"},
                             {"-1e308", "1.7e308"},
                             {"1", ""},
                             {"1", "one"},
                             {"", "0"}})
    EXPECT_EQ(result(std::string("t,x\n0,") + a + "\n", std::string("t,x\n0,") + b + "\n"), "different")
        << a << b;
  EXPECT_EQ(result("t,x\n0,nan\n", "t,x\n0.0,nan\n"), "identical: the same numbers");
  EXPECT_EQ(result("t,x\n0,inf\n", "t,x\n0.0,inf\n"), "identical: the same numbers");
  EXPECT_EQ(result("t,x\n", "t,x \n"), "not compared: there are no numbers in them");
  EXPECT_EQ(result("", "\n"), "not compared: there are no numbers in them");
  EXPECT_EQ(result("t,x\n", "t,x\n0,1\n"), "different") << "no rows";
  EXPECT_EQ(result("t,x\n", "t,y\n"), "different") << "other headers";
  EXPECT_EQ(result("t,x\n0,1\n", "t,y\n0,1\n"), "different") << "other headers";
  EXPECT_EQ(result("x\n1\n", "x\n1\n1\n"), "different") << "another number of rows";
  EXPECT_EQ(compare_files("a.csv", "t\n1\n2\n", "t\n2\n1\n", {}).sameness, Sameness::different)
      << "rows reordered";
  const FileDifference tiny = compare_files("a.csv", "x\n1e308\n5e-324\n", "x\n1e308\n0\n", {});
  EXPECT_EQ(tiny.sameness, Sameness::within)
      << "too small a share to be told, but not the same: " << tiny.in_words;
}

std::string still(const std::string& row, int depth = 8, int kind = 2, const MadeChunks& extra = {}) {
  MadeChunks chunks{{"IHDR", header_of(2, 2, depth, kind)}};
  chunks.insert(chunks.end(), extra.begin(), extra.end());
  chunks.emplace_back("IDAT", rows_of(2, row));
  chunks.emplace_back("IEND", "");
  return file_of(chunks);
}

TEST(Diff, PicturesAreComparedAsTheyAreSeen) {
  const auto result = [](const std::string& a, const std::string& b) {
    return word(compare_files("a.png", a, b, {.channel = 0, .density = 0, .numbers = 0}).sameness);
  };
  const std::string black = still(std::string(6, '\0')), white = still(std::string(6, '\xFF'));
  EXPECT_EQ(result(black, white), "different");
  EXPECT_EQ(result(black, still(std::string(1, '\0'), 1, 0)), "identical") << "of another depth";
  EXPECT_EQ(result(white, still("\x80\x80", 8, 3, {{"PLTE", std::string(384, 'x') + "\xFF\xFF\xFF"}})),
            "identical")
      << "of a palette";
  EXPECT_EQ(result(white, still("\xFF\xFF", 8, 0)), "identical") << "of grays";
  EXPECT_EQ(result(white, still(std::string(12, '\xFF'), 16, 2)), "identical") << "of 16 bits";
  EXPECT_EQ(result(white, still(std::string(11, '\xFF') + '\xFE', 16, 2)), "different")
      << "by less than 8 bits tell";
  EXPECT_EQ(result(white, still(std::string(8, '\xFF'), 8, 6)), "identical") << "of opacity";
  EXPECT_EQ(result(white, still(std::string(7, '\xFF') + '\xFE', 8, 6)), "different") << "of another opacity";
  EXPECT_EQ(result(still(std::string("abc\0def\0", 8), 8, 6), still(std::string("xyz\0uvw\0", 8), 8, 6)),
            "identical")
      << "a colour without opacity";
  EXPECT_EQ(result(white, still("\xFF\xFF", 8, 0, {{"tRNS", u16(255)}})), "different")
      << "a gray without opacity";
  EXPECT_EQ(result(white, still("\xFF\xFF", 8, 0, {{"gAMA", u32(100000)}})), "different") << "another gamma";
  EXPECT_EQ(result(white, still("\xFF\xFF", 8, 0, {{"tEXt", "whatever"}})), "identical") << "a text";
}

struct MadeAnimation {
  std::string still_pixel = "abc";
  bool still_is_frame = false;
  std::vector<std::string> pixels{"abc", "XYZ"};
  std::uint32_t plays = 0;
  std::vector<MadeFrame> frames{{2, 2}, {2, 2}};

  std::string bytes() const {
    MadeChunks chunks{{"IHDR", header_of(2, 2)},
                      {"acTL", animation_of(static_cast<std::uint32_t>(pixels.size()), plays)}};
    std::uint32_t number = 0;
    if (!still_is_frame) chunks.emplace_back("IDAT", flat_data(2, 2, still_pixel));
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const std::string data =
          flat_data(static_cast<int>(frames[k].width), static_cast<int>(frames[k].height), pixels[k]);
      chunks.emplace_back("fcTL", control_of(number++, frames[k]));
      if (k == 0 && still_is_frame)
        chunks.emplace_back("IDAT", data);
      else
        chunks.emplace_back("fdAT", u32(number++) + data);
    }
    chunks.emplace_back("IEND", "");
    return file_of(chunks);
  }
};

TEST(Diff, AnimationsDifferInFramesDelaysPlaysAndStillPicture) {
  const MadeAnimation made;
  const std::string plain = made.bytes();
  const auto changed = [&](auto change) {
    MadeAnimation other = made;
    change(other);
    const FileDifference found = compare_files("a.png", plain, other.bytes(), {});
    return word(found.sameness) + ": " + found.in_words;
  };
  using Made = MadeAnimation;
  EXPECT_EQ(changed([](Made& m) {
              m.frames[1].delay = 2;
              m.frames[1].unit = 50;
            }),
            "identical: the same pixels");
  EXPECT_EQ(changed([](Made& m) { m.frames[1].unit = 1; }), "different: frame 1: shown for 1/25 and 1/1 s");
  EXPECT_EQ(changed([](Made& m) { m.frames[0].delay = 0; }), "different: frame 0: shown for 1/25 and 0/25 s");
  EXPECT_EQ(changed([](Made& m) { m.plays = 1; }), "different: played without end and 1 times");
  EXPECT_EQ(changed([](Made& m) { m.pixels.pop_back(); }), "different: 2 frames and 1 frames");
  EXPECT_TRUE(changed([](Made& m) { m.pixels[1] = "xyz"; }).starts_with("different: frame 1: 4 pixels"));
  EXPECT_TRUE(changed([](Made& m) { m.still_pixel = "xyz"; }).starts_with("different: the still picture"));
  EXPECT_EQ(changed([](Made& m) { m.still_is_frame = true; }), "identical: the same pixels")
      << "as all see it";
  EXPECT_TRUE(changed([](Made& m) {
                m.frames[1] = {1, 2, 1, 0};
              }).starts_with("different: frame 1: 2 pixels"))
      << "the other half is as before";
  EXPECT_TRUE(changed([](Made& m) {
                m.frames[0].after = 1;
                m.frames[1] = {1, 2, 1, 0};
              }).starts_with("different: frame 1: "));
  EXPECT_EQ(changed([](Made& m) { m.frames[1].blend = 1; }), "identical: the same pixels") << "it is opaque";
  EXPECT_EQ(changed([](Made& m) { m.frames[1].after = 1; }), "identical: the same pixels")
      << "it is the last";
}

TEST(Diff, EmptyAnimationsAreTheirStillPictureAndNoStillPicture) {
  const auto empty = [](const std::string& pixel) {
    return still(pixel + pixel, 8, 2, {{"acTL", animation_of(1)}});
  };
  EXPECT_EQ(compare_files("a.png", empty("abc"), empty("xyz"), {}).sameness, Sameness::different);
  EXPECT_EQ(compare_files("a.png", empty("abc"), empty("abc"), {}).sameness, Sameness::identical);
  EXPECT_EQ(compare_files("a.png", empty("abc"), still("abcabc"), {}).in_words,
            "an animation without frames and a still picture");
  EXPECT_EQ(compare_files("a.png", empty("abc"), MadeAnimation().bytes(), {}).in_words,
            "an animation without frames and 2 frames");
  EXPECT_EQ(compare_files("a.png", still("abcabc"), MadeAnimation().bytes(), {}).in_words,
            "a still picture and 2 frames");
}

TEST(Diff, VerdictsOfOneNameAndOfListedReportsAreAllCompared) {
  const auto result = [](const std::string& a, const std::string& b) {
    return compare_files("results.json", a, b, {}).in_words;
  };
  const auto two = [](const char* first, const char* second) {
    return fmt::format(R"({{"verdicts":[{{"name":"a","status":"{}"}},{{"name":"a","status":"{}"}}]}})", first,
                       second);
  };
  EXPECT_EQ(result(two("failed", "passed"), two("passed", "passed")), "a: failed → passed");
  EXPECT_EQ(result(two("passed", "failed"), two("passed", "passed")), "a (2): failed → passed");
  EXPECT_EQ(result(R"({"reports":[)" + std::string(R"({"folder":"x","outcome":"accurate"}]})"),
                   R"({"reports":[{"folder":"x","outcome":"unstable"}]})"),
            "x: outcome: accurate → unstable");
  EXPECT_EQ(result(R"({"outcome":"accurate"})", R"({"outcome":null})"), "outcome: accurate → no text");
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
  const Ended others = diff({"a", "b", "--accept", "--channel", "0"});
  EXPECT_EQ(others.status, 0) << "nothing differs";
  write_text(folder / "b/x.csv", "t,x\n0,3\n");
  EXPECT_EQ(diff({"a", "b", "--accept"}).status, 5)
      << "a folder that was not made by accepting is left alone";
  fs::remove_all(folder / "a");
  write_text(folder / "b/x.csv", "t,x\n0,1\n");
  EXPECT_EQ(diff({"a", "b", "--accept"}).status, 0);
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

TEST_F(DiffProgram, AcceptTakesFilesOfAnyNameOrRefusesThemBeforeAnyWork) {
  fs::remove_all(folder / "a");
  const std::vector<std::string> names{"both.json",    "new.json",    "removed/x",        "old/x",
                                       "new/new.json", ".plumb-part", "sub/manifest.json"};
  for (const std::string text : {"first", "second", "third"}) {
    for (const std::string& name : names) write_text(folder / "b" / name, text + name);
    if (text == "third") write_text(folder / "a/mine.txt", "mine");
    const Ended ended = diff({"a", "b", "--accept"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const std::string& name : names) EXPECT_EQ(read_text(folder / "a" / name), text + name);
  }
  EXPECT_EQ(read_text(folder / "a/mine.txt"), "mine");
  const auto refused = [&](const std::string& says) {
    const Ended ended = diff({"a", "b", "--accept", "--quiet"});
    EXPECT_EQ(ended.status, 3) << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_EQ(read_text(folder / "a/both.json"), "thirdboth.json");
  };
  write_text(folder / "b/\xff", "x");
  refused("b/\\xff: has a name that is no UTF-8");
  fs::remove(folder / "b/\xff");
  fs::create_symlink("nowhere", folder / "b/link");
  refused("b/link: is no file, or a link to none");
  fs::remove(folder / "b/link");
  write_text(folder / "b/both.json", "fourth");
  write_text(folder / "b/manifest.json", "{\"name\": \"a web page\"}");
  refused("b/manifest.json: it is none of Plumb");
}

TEST_F(DiffProgram, AcceptClearsWhatAKilledOneLeftEvenWithNothingToAccept) {
  fs::remove_all(folder / "a");
  ASSERT_EQ(diff({"a", "b", "--accept"}).status, 0);
  for (const std::string name : {"a", "a/x.csv"}) {
    const fs::path place = folder / name;
    const pid_t child = ::fork();
    if (child == 0) {
      PartFolder part(place.parent_path().string(), place.filename().string());
      part.create("half");
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    const Ended ended = diff({name, name == "a" ? "b" : "b/x.csv", "--accept"});
    EXPECT_NE(ended.out.find("nothing to accept"), std::string::npos) << ended.out << ended.err;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      EXPECT_EQ(entry.path().string().find(".part-"), std::string::npos) << entry.path();
  }
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
  write_text(folder / "broken.csv", "x\n\"1\n");
  for (const auto& [arguments, status] : {std::pair<std::vector<std::string>, int>{{"a"}, 2},
                                          {{"a", "b", "--channel", "256"}, 2},
                                          {{"a", "b", "--channel", "x"}, 2},
                                          {{"a", "b", "--density", "1.5"}, 2},
                                          {{"a", "b", "--density", "0.51"}, 2},
                                          {{"a", "b", "--channel", "128"}, 2},
                                          {{"a", "b", "--numbers", "-1"}, 2},
                                          {{"a", "nothing"}, 3},
                                          {{"a", "a.txt"}, 3},
                                          {{"a/run.h5", "/dev/null"}, 3},
                                          {{"a/x.csv", "broken.csv"}, 3},
                                          {{"a", "b", "--html", "no/such/folder/page.html"}, 5}}) {
    const Ended ended = diff(arguments);
    EXPECT_EQ(ended.status, status) << testing::PrintToString(arguments) << ended.err;
    expect_one_line(ended.err);
  }
}

TEST_F(DiffProgram, NothingComparedIsNoAgreement) {
  fs::create_directories(folder / "empty");
  fs::create_directories(folder / "hollow/within");
  write_text(folder / "c/run.h5", "first");
  write_text(folder / "d/run.h5", "second");
  write_text(folder / "e/x.csv", "t,x\n");
  write_text(folder / "f/x.csv", "t,x\n");
  write_text(folder / "g/results.json", R"({"verdicts":[]})");
  write_text(folder / "h/results.json", R"({"verdicts":[], "seconds": 1})");
  for (const auto& [a, b] :
       {std::pair{"empty", "hollow"}, {"c", "d"}, {"e", "f"}, {"g", "h"}, {"c/run.h5", "d/run.h5"}}) {
    const Ended ended = diff({a, b});
    EXPECT_EQ(ended.status, 1) << a << ended.out << ended.err;
    EXPECT_NE(ended.out.find("no agreement"), std::string::npos) << ended.out;
    const Json json = Json::parse(diff({a, b, "--json"}).out);
    EXPECT_EQ(json["compared"], 0) << a;
    EXPECT_TRUE(json["different"].is_null()) << json;
    EXPECT_EQ(json["agree"], false) << json;
    const Ended accepting = diff({a, b, "--accept"});
    EXPECT_EQ(accepting.status, 1) << a << accepting.out;
  }
}

TEST_F(DiffProgram, FilesOfUnknownKindsAreComparedByTheirBytes) {
  write_text(folder / "a/notes.txt", std::string(3'000'000, 'x') + "a");
  write_text(folder / "b/notes.txt", std::string(3'000'000, 'x') + "b");
  EXPECT_NE(diff({"a", "b"}).out.find("1 of 2 files differ"), std::string::npos);
  write_text(folder / "b/notes.txt", std::string(3'000'000, 'x') + "a");
  EXPECT_NE(diff({"a", "b"}).out.find("None of 2 files differs"), std::string::npos);
  EXPECT_EQ(diff({"a/notes.txt", "b/notes.txt"}).status, 0);
  write_text(folder / "b/notes.txt", std::string(3'000'000, 'x'));
  EXPECT_EQ(diff({"a/notes.txt", "b/notes.txt"}).status, 1);
}

TEST_F(DiffProgram, WhatIsNoFileIsNeverTheSame) {
  const auto unreadable = [&](const char* what) {
    const Ended ended = diff({"a", "b"});
    EXPECT_EQ(ended.status, 1) << what << ended.out << ended.err;
    EXPECT_NE(ended.out.find("unreadable"), std::string::npos) << what << ended.out;
  };
  for (const char* side : {"a/odd", "b/odd"}) fs::create_directory_symlink(folder / "a", folder / side);
  unreadable("links to folders");
  for (const char* side : {"a/odd", "b/odd"}) {
    fs::remove(folder / side);
    fs::create_symlink("nowhere", folder / side);
  }
  unreadable("links to nothing");
  for (const char* side : {"a/odd", "b/odd"}) {
    fs::remove(folder / side);
    ASSERT_EQ(::mkfifo((folder / side).c_str(), 0600), 0);
  }
  unreadable("pipes");
  const Ended pipe = diff({"a/odd", "b/x.csv"});
  EXPECT_EQ(pipe.status, 3);
  expect_one_line(pipe.err);
}

TEST_F(DiffProgram, ThePathsThatOverlapAreToldAndNeverAccepted) {
  write_text(folder / "a/sub/x.csv", "t,x\n0,2\n");
  fs::create_directory_symlink(folder / "a", folder / "link");
  const Ended same = diff({"a", "link"});
  EXPECT_EQ(same.status, 0);
  EXPECT_NE(same.err.find("are the same"), std::string::npos) << same.err;
  EXPECT_NE(diff({"a", "a/sub"}).err.find("lies in"), std::string::npos);
  for (const auto& [first, second] : {std::pair{"a", "a"},
                                      {"a", "./a/"},
                                      {"a", "link"},
                                      {"a", "a/sub"},
                                      {"a/sub", "a"},
                                      {"a/new", "a"},
                                      {"link/sub", "a"},
                                      {"a", "a/../a/sub"},
                                      {"a/x.csv", "link/x.csv"}}) {
    const Ended ended = diff({first, second, "--accept"});
    EXPECT_EQ(ended.status, 2) << first << " " << second << ended.out;
    expect_one_line(ended.err);
  }
  EXPECT_EQ(read_text(folder / "a/x.csv"), "t,x\n0,1\n");
  EXPECT_EQ(read_text(folder / "a/sub/x.csv"), "t,x\n0,2\n");
  EXPECT_EQ(diff({"a", "b", "--html", "a/x.csv"}).status, 2);
  EXPECT_EQ(diff({"a/x.csv", "b/x.csv", "--html", "b/x.csv"}).status, 2);
  EXPECT_EQ(read_text(folder / "b/x.csv"), "t,x\n0,1\n") << "what is compared is not written over";
}

TEST_F(DiffProgram, APictureTooLargeIsRefusedAtOnce) {
  const std::string bomb =
      file_of({{"IHDR", header_of(32768, 32768)}, {"IDAT", deflated("x")}, {"IEND", ""}});
  write_text(folder / "a/big.png", bomb);
  write_text(folder / "b/big.png", bomb);
  const Ended ended = diff({"a/big.png", "b/big.png"});
  EXPECT_EQ(ended.status, 3) << ended.out;
  expect_one_line(ended.err);
  EXPECT_EQ(diff({"a", "b"}).status, 1) << "within a folder the others are compared all the same";
}

/// Of the processor, s, that a process under way has taken; -1 where it has ended.
double seconds_of(pid_t process) {
  const std::string status = read_text("/proc/" + std::to_string(process) + "/stat");
  const std::size_t name_ends = status.rfind(") ");
  if (name_ends == std::string::npos || status.substr(name_ends + 2, 1) == "Z") return -1;
  std::istringstream words(status.substr(name_ends + 2));
  std::string word;
  for (int k = 0; k < 11; ++k) words >> word;
  double user = 0, system = 0;
  words >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// The same of all that this one started and that have ended.
double seconds_of_ended() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

TEST_F(DiffProgram, IsInterruptedWithinASecond) {
  // Many seconds of pixels for a processor of today.
  const std::string data = rows_of(4000, std::string(4000 / 8, '\x55'));
  std::string bytes[2];
  for (int i = 0; i < 2; ++i) {
    MadeChunks chunks{{"IHDR", header_of(4000, 4000, 1, 0)}, {"acTL", animation_of(100)}, {"IDAT", data}};
    std::uint32_t number = 0;
    for (int k = 0; k < 100; ++k) {
      chunks.emplace_back("fcTL",
                          control_of(number++, {4000, 4000, 0, 0, 1, 25, 0, i == 1 && k == 99 ? 1 : 0}));
      chunks.emplace_back("fdAT", u32(number++) + data + (i == 1 ? " " : ""));
    }
    chunks.emplace_back("IEND", "");
    bytes[i] = file_of(chunks);
  }
  write_text(folder / "a.png", bytes[0]);
  write_text(folder / "b.png", bytes[1]);
  const double before = seconds_of_ended();
  const pid_t child = start({PLUMB_PROGRAM, "diff", "a.png", "b.png"}, folder.path());
  double asked = 0;
  while (asked >= 0 && asked < 0.3) {
    ::usleep(1000);
    asked = seconds_of(child);
  }
  ASSERT_GE(asked, 0) << "it ended before it could be interrupted";
  ::kill(child, SIGINT);
  const Ended ended = finish(child, folder.path());
  EXPECT_EQ(ended.status, 130) << ended.out << ended.err;
  EXPECT_LT(seconds_of_ended() - before - asked, 1) << "s of the processor";
}

TEST(Diff, ANumberThatIsNotFiniteHidesNoOtherOfItsColumn) {
  for (const char* far : {"inf", "-inf", "nan"}) {
    const std::string start = fmt::format("x\n{}\n", far);
    const FileDifference found = compare_files("a.csv", start + "1\n", start + "2\n", {});
    EXPECT_EQ(found.sameness, Sameness::different) << far;
    EXPECT_DOUBLE_EQ(found.number, 0.5) << far;
  }
}

TEST(Diff, OnlyPicturesAndNumbersHaveADistance) {
  EXPECT_EQ(compare_files("a.txt", "one", "other", {}).number, -1);
  EXPECT_EQ(compare_files("run.h5", "one", "other", {}).number, -1);
  EXPECT_EQ(compare_files("a.csv", "t,x\n", "t,x \n", {}).number, -1);
  const FileDifference unreadable = compare_files("a.png", "no picture", "nor this", {});
  EXPECT_EQ(unreadable.sameness, Sameness::unreadable);
  EXPECT_EQ(unreadable.number, -1);
}

TEST(Diff, WhatDiffersInPicturesIsSaidInNumbers) {
  const FileDifference found = compare_files("a.png", still("abcabc"), still("abcabz"), {});
  EXPECT_EQ(
      found.in_words,
      "2 pixels differ, by up to 23 levels; 2 by more than 8, at most 50 % of a window of 16 pixels, at "
      "(0, 0); 1 % are allowed");
  EXPECT_DOUBLE_EQ(found.number, 0.5);
  EXPECT_EQ(compare_files("a.png", still("abcabc"), MadeAnimation().bytes(), {}).number, -1)
      << "another kind has no distance";
}

TEST(Diff, PicturesAreHeldToTheToleranceThatIsAskedFor) {
  const auto result = [](const std::string& a, const std::string& b, int channel, double density) {
    return word(compare_files("a.png", a, b, {.channel = channel, .density = density}).sameness);
  };
  const std::string black = still(std::string(6, '\0')), white = still(std::string(6, '\xFF'));
  EXPECT_EQ(result(black, white, 0, 1), "within tolerance") << "all pixels may differ";
  EXPECT_EQ(result(black, white, 0, 0.99), "different");
  EXPECT_EQ(result(black, white, 255, 0), "within tolerance") << "by all levels";
  EXPECT_EQ(result(black, white, 254, 0), "different");
  const std::string finer = still(std::string(11, '\xFF') + '\xFE', 16, 2);
  EXPECT_EQ(result(white, finer, 1, 0), "within tolerance") << "by less than a level";
  EXPECT_EQ(result(white, finer, 0, 1), "different") << "no level is allowed";
}

TEST(Diff, OneRendererMustGiveTheSameBytesUnlessATolerance) {
  const auto picture = [](std::uint8_t level, const char* renderer) {
    return encode_png(Image{2, 2, std::vector<std::uint8_t>(12, level)}, {{renderer_keyword, renderer}});
  };
  const std::string before = picture(100, "one");
  const auto result = [&](const std::string& now, const DifferenceOptions& options) {
    return compare_files("a.png", before, now, options);
  };
  const std::string demand = "the same renderer must give the same bytes";
  const FileDifference strict = result(picture(101, "one"), {});
  EXPECT_EQ(word(strict.sameness), "different");
  EXPECT_NE(strict.in_words.find(demand), std::string::npos) << strict.in_words;
  for (const FileDifference& loose :
       {result(picture(101, "other"), {}), result(picture(101, "one"), {.channel = 8, .density = {}}),
        result(picture(101, "one"), {.channel = {}, .density = 0.01})}) {
    EXPECT_EQ(word(loose.sameness), "within tolerance");
    EXPECT_EQ(loose.in_words.find(demand), std::string::npos) << loose.in_words;
    EXPECT_EQ(loose.first + loose.second + loose.marks, "") << "none are asked for";
  }
  const FileDifference shown = result(picture(101, "one"), {.channel = {}, .density = {}, .pictures = true});
  EXPECT_FALSE(shown.first.empty() || shown.second.empty() || shown.marks.empty());
}

TEST(Diff, WhatDrewTwoPicturesIsSaidBeforeTheirPixels) {
  const auto picture = [](std::uint8_t level, const PngTexts& texts) {
    return encode_png(Image{2, 2, std::vector<std::uint8_t>(12, level)}, texts);
  };
  const std::string before = picture(100, {{renderer_keyword, "Mesa 1; FreeType 1"}});
  const auto words = [&](const std::string& now) { return compare_files("a.png", before, now, {}).in_words; };
  EXPECT_TRUE(words(picture(200, {{renderer_keyword, "Mesa 1; FreeType 2"}}))
                  .starts_with("drawn by Mesa 1; FreeType 1 and by Mesa 1; FreeType 2: 4 pixels differ"))
      << words(picture(200, {{renderer_keyword, "Mesa 1; FreeType 2"}}));
  EXPECT_TRUE(words(picture(200, {})).starts_with("drawn by Mesa 1; FreeType 1 and by what is not said: "))
      << words(picture(200, {}));
  EXPECT_TRUE(words(picture(200, {{renderer_keyword, "Mesa 1; FreeType 1"}})).starts_with("4 pixels"))
      << words(picture(200, {{renderer_keyword, "Mesa 1; FreeType 1"}}));
}

TEST(Diff, TheWorstFrameIsTold) {
  const MadeAnimation base{.pixels = {"abc", "abc", "abc"}, .frames = {{2, 2}, {2, 2}, {2, 2}}};
  MadeAnimation all_then_half = base, half_then_all = base;
  all_then_half.pixels[1] = half_then_all.pixels[1] = half_then_all.pixels[2] = "xyz";
  all_then_half.frames[2] = half_then_all.frames[1] = {1, 2, 1, 0};
  for (const auto& [made, begin] :
       {std::pair{all_then_half, "frame 1: 4 pixels"}, {half_then_all, "frame 2: 4 pixels"}}) {
    const FileDifference found = compare_files("a.png", base.bytes(), made.bytes(), {});
    EXPECT_DOUBLE_EQ(found.number, 1) << begin;
    EXPECT_TRUE(found.in_words.starts_with(begin)) << found.in_words;
  }
}

TEST(Diff, TheStillPictureIsComparedUnlessItIsAFrameOfBoth) {
  const auto result = [](const MadeAnimation& a, const MadeAnimation& b) {
    const FileDifference found = compare_files("a.png", a.bytes(), b.bytes(), {});
    return found.in_words.substr(0, found.in_words.find_first_of(",:"));
  };
  const MadeAnimation beside{.still_pixel = "xyz"}, frame{.still_is_frame = true},
      other_frame{.still_is_frame = true, .pixels = {"xyz", "XYZ"}};
  EXPECT_EQ(result(beside, frame), "the still picture");
  EXPECT_EQ(result(frame, beside), "the still picture");
  EXPECT_EQ(result(frame, other_frame), "frame 0");
}

TEST(Diff, LongFilesOfUnknownKindsAreComparedToTheirLastByte) {
  const TemporaryFolder folder;
  const std::string a = (folder / "a.txt").string(), b = (folder / "b.txt").string();
  const auto result = [&](const std::string& one, const std::string& other) {
    write_text(a, one);
    write_text(b, other);
    return word(compare_paths(a, b, {}).at(0).sameness);
  };
  EXPECT_EQ(result("", ""), "identical");
  EXPECT_EQ(result("x", "x"), "identical");
  EXPECT_EQ(result("x", "xx"), "different");
  const std::string part(1U << 20, 'x');  // that is read at a time
  EXPECT_EQ(result(part, part), "identical");
  EXPECT_EQ(result(part + "a", part + "b"), "different");
}

TEST(Diff, NumbersThatDifferAreToldWithLineAndColumn) {
  const std::string words = compare_files("a.csv", "t,x\n0,1\n1,2\n", "t,x\n0,1\n1,3\n", {}).in_words;
  EXPECT_NE(words.find("line 3, x: 2 and 3"), std::string::npos) << words;
}

TEST(Diff, AVerdictOfAnotherKindOrCriterionIsADifference) {
  for (const char* key : {"kind", "criterion"}) {
    const auto with = [&](const char* value) {
      return fmt::format(R"({{"verdicts":[{{"name":"a","status":"passed","{}":"{}"}}]}})", key, value);
    };
    const FileDifference found = compare_files("results.json", with("one"), with("other"), {});
    EXPECT_EQ(word(found.sameness), "different") << key;
    EXPECT_EQ(found.in_words, fmt::format("a, {}: one → other", key));
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

}  // namespace diff_test
}  // namespace plumb
