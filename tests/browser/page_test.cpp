#include "report/page/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "engine/base/file_text.h"
#include "render/image/apng.h"
#include "render/image/png.h"
#include "report/base/base64.h"
#include "report/document/document.h"
#include "tests/browser/chromium.h"
#include "tests/report/made_run.h"
#include "tests/report/program/program.h"

// The page of a run in Debian's Chromium. All tests read the same pages, which the first one makes: of a
// run of the pendulum, of one that failed, of both beside one another, of a study, and of one with hostile
// texts. They do so in one browser, which the second one leaves for them, or each in its own where there is
// none.

namespace plumb {
namespace {

constexpr int tab_key = 9, left_key = 37, right_key = 39;

const fs::path pages = PLUMB_PAGES, browser = pages.string() + "_browser";

/// Of those that run one after another in one process.
struct Shared {
  TemporaryFolder folder;
  std::optional<Chromium> chromium;
  std::string why_not;
};

/// The pendulum with a small study and small pictures.
std::string small_pendulum() {
  std::string text = read_text(case_path("pendulum.toml"));
  text = text.substr(0, text.find("[study."));
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace("\"references/", "\"" + case_path("references/"));
  replace("[960, 540]", "[320, 180]");
  replace("rtol = 1e-10", "rtol = 1e-7");
  replace("samples = 24", "samples = 6");
  replace("cable.elements = 64", "cable.elements = 8");
  return text + R"(
[study.work_precision]
end = 0.2
elements = [4, 8]
points = 4
[study.work_precision.quick]
elements = [4]
points = 4
repeats = 1
time_limit = 0.1
methods = ["rk4", "generalized-alpha"]
)";
}

const std::string hostile =
    R"(</title></script><script>window.broken = 1</script>"'&<img src=x onerror="window.broken = 2">]]>)"
    "\u2028{{title}}";

/// A report of a made run, with stand-ins for its pictures.
std::string hostile_page() {
  Run run = run_with("made");
  run.loaded.spec.title = hostile;
  run.loaded.source.file.name = hostile + ".toml";
  run.loaded.source.overrides = {hostile};
  run.loaded.references[0].title = run.loaded.references[0].source = hostile;
  run.loaded.references[0].notes = {hostile};
  run.loaded.spec.references[0].reason = hostile;
  run.provenance = {{hostile, hostile}};
  const std::string png = encode_png({2, 1, {255, 255, 255, 0, 0, 0}});
  Pictures pictures;
  Picture picture{"figures/" + hostile + ".png", hostile, hostile, false, png};
  picture.plot.panels.resize(1);
  picture.plot.panels[0].x.label = picture.plot.panels[0].y.label = hostile;
  Series series;
  series.label = hostile;
  series.x = series.y = {0, 1};
  picture.plot.panels[0].series.push_back(series);
  picture.times = {{true, {}}};
  pictures.figures = {picture};
  pictures.page_animation = pictures.page_still = png;
  pictures.page_animation_width = 2;
  pictures.page_animation_height = 1;
  pictures.player_frame_rate = 1;
  return to_page(document_of(evaluate(run, {}), pictures), pictures);
}

TEST(Pages, AreMade) {
  fs::remove_all(pages);
  write_text(pages / "small.toml", small_pendulum());
  const Ended run = plumb_in(pages, {"run", "small.toml", "-o", "run", "--history", "runs.jsonl"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Ended failing = plumb_in(pages, {"run", "small.toml", "-o", "failed", "--set", "method.name=rk4",
                                         "--set", "method.step=1.3e-3", "--set", "study={}"});
  ASSERT_EQ(failing.status, 4) << failing.err;
  write_text(pages / "hostile.html", hostile_page());
  const Ended both = plumb_in(pages, {"report", "run", "failed", "-o", "index", "--history", "runs.jsonl"});
  ASSERT_EQ(both.status, 4) << both.err;
  std::string text = small_pendulum();
  const std::string points = "points = 4\n[study.work_precision.quick]";
  text.replace(text.find(points), points.size(),
               "points = 3\nmethods = [\"rk4\"]\n[study.work_precision.quick]");
  write_text(pages / "study.toml", text);
  const Ended study = plumb_in(pages, {"study", "study.toml", "work-precision", "-o", "study"});
  ASSERT_LE(study.status, 1) << study.err;
}

TEST(Pages, HaveABrowserThatAnotherProcessCanUse) {
  fs::remove_all(browser);
  fs::create_directories(browser);
  try {
    Chromium::leave_one(PLUMB_CHROMIUM, browser.string());
  } catch (const std::exception& error) {
    GTEST_SUCCEED() << "those that look at pages tell why it does not start: " << error.what();
    return;
  }
  EXPECT_NO_THROW(Chromium(browser.string()).call("Browser.getVersion"));
}

class PageInBrowser : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = new Shared;
    const fs::path& folder = shared_->folder.path();
    try {
      shared_->chromium.emplace(browser.string());
      return;
    } catch (const std::exception&) {
      // None was left, or it has ended or is used.
    }
    try {
      shared_->chromium.emplace(PLUMB_CHROMIUM, folder.string());
    } catch (const std::exception& error) {
      shared_->why_not = std::string(error.what()) + "\n" + read_text(folder / "chromium.log");
    }
  }
  static void TearDownTestSuite() {
    delete shared_;
    shared_ = nullptr;
  }

  void SetUp() override {
    if (!shared_->chromium) GTEST_SKIP() << "the browser does not start: " << shared_->why_not;
    tab_.emplace(*shared_->chromium);
    tab().resize(1400, 900);
    // Nothing moves by itself, but where that is what is tested.
    tab().emulate({{"prefers-reduced-motion", "reduce"}});
  }
  void TearDown() override { tab_.reset(); }

  Tab& tab() { return *tab_; }
  static std::string file(const std::string& name) { return (pages / name).string(); }
  void open(const std::string& page) { tab().open("file://" + file(page)); }
  void open_run() { open("run/index.html"); }
  Chromium& chromium() { return *shared_->chromium; }
  static Json results() { return Json::parse(read_text(pages / "run/results.json")); }

  std::string text_of(const std::string& selector) {
    return tab().value_of("document.querySelector('" + selector + "').innerText").get<std::string>();
  }
  long count(const std::string& selector) {
    return tab()
        .value_of("[...document.querySelectorAll('" + selector +
                  "')].filter((node) => node.checkVisibility()).length")
        .get<long>();
  }
  void focus(const std::string& selector) {
    tab().value_of("document.querySelector('" + selector + "').focus()");
  }
  /// Moves the mouse to a time in a chart, by its place in the page.
  void point_at(int chart, double time) {
    const std::string the = "plumb.charts[" + std::to_string(chart) + "]";
    tab().value_of(the + ".canvas.scrollIntoView({block: 'center'})");
    const Json place =
        tab().value_of("(() => { const box = " + the + ".canvas.getBoundingClientRect(); const c = " + the +
                       ".chart; return [box.left + c.scales.x.getPixelForValue(" + std::to_string(time) +
                       "), box.top + (c.chartArea.top + c.chartArea.bottom) / 2]; })()");
    tab().move_mouse(place[0], place[1]);
  }

 private:
  static Shared* shared_;
  std::optional<Tab> tab_;
};

Shared* PageInBrowser::shared_ = nullptr;

/// A number as the page writes it.
double number_in(std::string text) {
  const std::string minus = "−";
  if (text.starts_with(minus)) text = "-" + text.substr(minus.size());
  return std::stod(text);
}

// FNV-1a over red, green and blue, with 32 bits.
std::uint32_t hash_of(const Image& image) {
  std::uint32_t hash = 2166136261U;
  for (const std::uint8_t byte : image.rgb) hash = (hash ^ byte) * 16777619U;
  return hash;
}

/// A script of this folder.
std::string script(const std::string& name) {
  return read_text(std::string(PLUMB_SOURCE_DIR) + "/tests/browser/" + name);
}

TEST_F(PageInBrowser, AsksNothingOfAnywhereAndComplainsOfNothing) {
  for (const char* page : {"run/index.html", "failed/index.html", "hostile.html"}) {
    open(page);
    tab().value_of("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
    EXPECT_EQ(tab().complaints(), std::vector<std::string>{}) << page;
    EXPECT_GT(tab().value_of("plumb.charts.length"), 0) << page << ": the scripts did run";
  }
}

TEST_F(PageInBrowser, ShowsHostileTextsAsTheyAre) {
  open("hostile.html");
  EXPECT_EQ(tab().value_of("typeof window.broken"), "undefined");
  EXPECT_EQ(tab().value_of("document.querySelector('h1').textContent"), hostile);
  EXPECT_NE(tab().value_of("document.title").get<std::string>().find(hostile), std::string::npos);
  EXPECT_EQ(tab().value_of("plumb.data.figures[0].title"), hostile);
  EXPECT_EQ(tab().value_of("document.querySelectorAll('img[src=x]').length"), 0);
  EXPECT_EQ(tab().value_of("document.querySelector('figure.plot img').alt"), hostile);
  EXPECT_NE(text_of(".command code").find("window.broken"), std::string::npos);
}

TEST_F(PageInBrowser, SliderShowsJustTheFrameOfItsPlace) {
  open_run();
  const std::vector<std::string> frames = split_apng(read_text(file("run/player.png")), "player.png");
  ASSERT_GT(frames.size(), 20U);
  focus("#player-time");
  std::vector<std::uint32_t> hashes;
  int at = 0;
  for (const int frame : {0, 1, 7, 20}) {
    for (; at < frame; ++at) tab().press("ArrowRight", right_key);
    tab().wait_until("document.querySelector('.player canvas').dataset.frame === '" + std::to_string(frame) +
                     "'");
    hashes.push_back(hash_of(decode_png(frames[static_cast<std::size_t>(frame)], "frame")));
    EXPECT_EQ(tab().value_of(script("hash_of_canvas.js")), hashes.back()) << "frame " << frame;
    EXPECT_NEAR(tab().value_of("plumb.clock.time").get<double>(), frame / 12.5, 1e-12);
  }
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::unique(hashes.begin(), hashes.end()), hashes.end()) << "the frames differ";
}

TEST_F(PageInBrowser, PlayerShowsWholeFramesAtEveryWidth) {
  const std::vector<std::string> frames = split_apng(read_text(file("run/player.png")), "player.png");
  const Image first = decode_png(frames.at(0), "frame");
  // Without stillness, for which the picture that the player stands in for is not laid out.
  tab().emulate({{"prefers-reduced-motion", "no-preference"}});
  for (const int width : {240, 360, 1000, 1400}) {
    tab().resize(width, 900);
    open_run();
    tab().value_of("document.querySelector('.player').scrollIntoView()");
    tab().wait_until("plumb.player.playing");
    tab().value_of("plumb.player.stop(); plumb.clock.set(0)");
    tab().wait_until("document.querySelector('.player canvas').dataset.frame === '0'");
    EXPECT_EQ(
        tab().value_of("(({ width, height }) => [width, height])(document.querySelector('.player canvas'))"),
        Json({first.width, first.height}))
        << "on a page " << width << " px wide";
    EXPECT_EQ(tab().value_of(script("hash_of_canvas.js")), hash_of(first))
        << "on a page " << width << " px wide";
  }
}

TEST_F(PageInBrowser, PlayerShowsFramesThatAreDecodedAfterTheirTime) {
  open_run();
  tab().wait_until("document.querySelector('.player canvas').dataset.frame === '0'");
  // A frame lasts 0.08 s, and is decoded in more than two of them; the second one in still more.
  tab().value_of(
      "(() => { const real = createImageBitmap; let calls = 0; window.shown = []; "
      "window.createImageBitmap = async (blob) => { const wait = calls++ === 0 ? 600 : 200; "
      "await new Promise((done) => setTimeout(done, wait)); return real(blob); }; "
      "new MutationObserver(() => shown.push(Number(document.querySelector('.player canvas').dataset.frame)))"
      ".observe(document.querySelector('.player canvas'), { attributeFilter: ['data-frame'] }); "
      "document.querySelector('.play').click(); })()");
  tab().wait_until("document.querySelector('.player canvas').dataset.frame === '25'");
  const auto shown = tab().value_of("shown").get<std::vector<int>>();
  EXPECT_GT(shown.size(), 3U) << "all but the last were dropped";
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end())) << Json(shown) << ": an older one over a newer one";
}

TEST_F(PageInBrowser, PointingAtATimeShowsTheNumbersOfTheResultsAndThatFrame) {
  open_run();
  const Json document = results();
  for (const std::size_t k : {0U, 37U, 100U}) {
    const double time = document["probes"]["t"]["values"][k];
    point_at(0, time);
    const std::string panel = "plumb.charts[0].node.querySelector";
    // To the digits that the uncertainty bears, until they are asked for.
    const std::string few = tab().value_of(panel + "('.value').textContent");
    EXPECT_LE(few.size(), 9U) << few;
    EXPECT_NEAR(number_in(few), document["probes"]["mid.y"]["values"][k].get<double>(), 2e-3);
    tab().value_of("for (const chart of plumb.charts) chart.showAll(false)");
    for (const int chart : {0, 1, 4})
      tab().value_of("plumb.charts[" + std::to_string(chart) + "].node.querySelector('.value').click()");
    EXPECT_EQ(number_in(tab().value_of(panel + "('.moment').textContent")), time);
    EXPECT_EQ(number_in(tab().value_of(panel + "('.value').textContent")),
              document["probes"]["mid.y"]["values"][k].get<double>())
        << "at " << time;
    EXPECT_EQ(number_in(tab().value_of(panel + "All('.value')[1].textContent")),
              document["errors"][0]["expected"][k].get<double>());
    EXPECT_EQ(number_in(tab().value_of("plumb.charts[1].node.querySelector('.value').textContent")),
              document["errors"][0]["difference"][k].get<double>());
    tab().value_of("plumb.charts[0].node.querySelector('.value').click()");
    EXPECT_EQ(tab().value_of(panel + "('.value').textContent"), few);
    EXPECT_EQ(tab().value_of("new Set(plumb.charts.filter((c) => c.timed).map((c) => "
                             "c.canvas.getAttribute('aria-valuenow'))).size"),
              1)
        << "every chart is at that time";
    tab().wait_until("document.querySelector('.player canvas').dataset.frame === '" +
                     std::to_string(std::min(25L, std::lround(12.5 * time))) + "'");
  }
  EXPECT_EQ(number_in(tab().value_of("plumb.charts[4].node.querySelector('.value').textContent")),
            document["energy"]["kinetic"][100].get<double>());
}

TEST_F(PageInBrowser, LegendsAndLabelsOfChartsAreThoseOfWhatIsDrawn) {
  open_run();
  const Json samples = tab().value_of(
      "plumb.charts.flatMap(({ panel, chart, values }) => panel.series.map((series, k) => ({ label: "
      "series.label, "
      "drawn: chart.data.datasets[k].borderDash.join(' '), line: chart.data.datasets[k].showLine, "
      "shown: (values[k].sample.querySelector('path')?.getAttribute('stroke-dasharray')) ?? '', "
      "path: values[k].sample.querySelectorAll('path').length, "
      "points: values[k].sample.querySelectorAll('circle').length, "
      "drawn_points: chart.data.datasets[k].pointRadius > 0 })))");
  long dashed = 0;
  for (const Json& sample : samples) {
    EXPECT_EQ(sample["shown"], sample["line"] == true ? sample["drawn"] : Json("")) << sample;
    EXPECT_EQ(sample["path"] == 1, sample["line"] == true) << sample;
    EXPECT_EQ(sample["points"] == 1, sample["drawn_points"] == true) << sample;
    dashed += sample["shown"] != "";
  }
  EXPECT_GT(dashed, 2);
  // Beside its axis a chart has the labels of the ticks, their marks, and the turned label: none over
  // another.
  const Json tight = tab().value_of(
      "plumb.charts.filter(({ chart }) => { const y = chart.scales.y, { ctx } = chart; ctx.font = '13px ' + "
      "getComputedStyle(document.body).fontFamily; const widest = Math.max(...y.ticks.map(({ label }) => "
      "ctx.measureText(label).width)), lines = y.options.title.text; return y.right - y.left < widest + 13 * "
      "1.2 * "
      "lines.length || lines.some((line) => ctx.measureText(line).width > chart.height); }).map(({ name, "
      "panel }) "
      "=> "
      "name + ' ' + panel.y.label)");
  EXPECT_EQ(tight, Json::array());
  EXPECT_EQ(tab().value_of("plumb.charts.some(({ panel }) => panel.y.label.includes('m⁻¹'))"), true);
  EXPECT_EQ(tab().value_of("[...document.querySelectorAll('.readout')].some((node) => /\\de[-−]\\d/"
                           ".test(node.textContent))"),
            false)
      << "powers of ten are typeset";
}

TEST_F(PageInBrowser, TimeMovesTheLineInEveryChart) {
  open_run();
  const auto dark_pixels_at = [&](int chart, double time) {
    // The line is darker than the grid over the whole height of the chart.
    return tab()
        .value_of(
            "(() => { const c = plumb.charts[" + std::to_string(chart) +
            "].chart, ratio = c.currentDevicePixelRatio; const x = Math.round(c.scales.x.getPixelForValue(" +
            std::to_string(time) +
            ") * ratio); const { data } = c.ctx.getImageData(x - 1, c.chartArea.top * "
            "ratio, 3, (c.chartArea.bottom - c.chartArea.top) * ratio); let n = 0; for (let k = 0; k < "
            "data.length; k += 4) if (data[k + 3] > 60 && data[k] + data[k + 1] + data[k + 2] < 200) ++n; "
            "return n; })()")
        .get<long>();
  };
  focus("#player-time");
  for (int k = 0; k < 9; ++k) tab().press("ArrowRight", right_key);
  tab().wait_until("plumb.clock.time > 0.7");
  for (const int chart : {0, 1, 3, 4}) {
    EXPECT_GT(dark_pixels_at(chart, 0.72), 40) << "chart " << chart;
    EXPECT_LT(dark_pixels_at(chart, 1.25), 30) << "chart " << chart;
  }
}

TEST_F(PageInBrowser, ArrowKeysMoveTheTimeOfAChart) {
  open_run();
  focus(".panel canvas");
  for (int k = 0; k < 3; ++k) tab().press("ArrowRight", right_key);
  tab().press("ArrowLeft", left_key);
  EXPECT_EQ(tab().value_of("plumb.clock.time"), results()["probes"]["t"]["values"][2]);
  const std::string said = tab().value_of("document.activeElement.getAttribute('aria-valuetext')");
  EXPECT_TRUE(said.starts_with("0.04 s: Plumb −")) << said;
}

TEST_F(PageInBrowser, PlaysByItselfOnlyForThoseWhoDoNotMind) {
  open_run();
  tab().value_of("document.querySelector('.player').scrollIntoView()");
  tab().value_of("new Promise((done) => setTimeout(done, 250))");
  EXPECT_EQ(tab().value_of("plumb.clock.time"), 0) << "its reader wants stillness";
  tab().emulate({{"prefers-reduced-motion", "no-preference"}});
  open_run();
  tab().value_of("document.querySelector('.player').scrollIntoView()");
  tab().wait_until("plumb.clock.time > 0.1 && plumb.player.playing");
  tab().value_of("document.querySelector('.play').click()");
  EXPECT_EQ(tab().value_of("plumb.player.playing"), false);
  EXPECT_EQ(text_of(".play"), "Play");
}

TEST_F(PageInBrowser, VerdictsCanBeFilteredByKindAndStatus) {
  open_run();
  const auto choose = [&](const std::string& key, const std::string& value) {
    tab().value_of("(() => { const select = document.getElementById('filter-" + key + "'); select.value = '" +
                   value + "'; select.dispatchEvent(new Event('change')); })()");
  };
  EXPECT_EQ(count("tr[data-status]"), 6);
  choose("kind", "validation");
  EXPECT_EQ(count("tr[data-status]"), 3);
  EXPECT_EQ(count(".verdict-group"), 1);
  EXPECT_EQ(text_of(".filter output"), "3 of 6 shown");
  EXPECT_EQ(tab().value_of("document.querySelector('.verdict-group:not([hidden])').dataset.kind"),
            "validation");
  open("failed/index.html");
  EXPECT_EQ(count("tr[data-status]"), 6);
  choose("status", "not run");
  EXPECT_EQ(count("tr[data-status]"), 6);
}

TEST_F(PageInBrowser, TablesCanBeSortedAndCopied) {
  open_run();
  chromium().call("Browser.grantPermissions",
                  {{"permissions", {"clipboardReadWrite", "clipboardSanitizedWrite"}}});
  const std::string head = "document.querySelectorAll('#errors th')[6]";
  const auto column = [&] {
    return tab()
        .value_of(
            "[...document.querySelectorAll('#errors tbody tr')].map((row) => "
            "Number(row.cells[6].textContent))")
        .get<std::vector<double>>();
  };
  ASSERT_EQ(column().size(), 6U);
  tab().value_of(head + ".querySelector('button').click()");
  EXPECT_EQ(tab().value_of(head + ".getAttribute('aria-sort')"), "ascending");
  std::vector<double> values = column();
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end())) << testing::PrintToString(values);
  tab().value_of(head + ".querySelector('button').click()");
  EXPECT_EQ(tab().value_of(head + ".getAttribute('aria-sort')"), "descending");
  values = column();
  EXPECT_TRUE(std::is_sorted(values.rbegin(), values.rend())) << testing::PrintToString(values);
  EXPECT_GT(values.front(), values.back());

  tab().call("Page.bringToFront");
  for (const auto& [button, separator] : {std::pair{0, "\t"}, {1, ","}}) {
    tab().value_of("document.querySelectorAll('#errors .table-tools button')[" + std::to_string(button) +
                   "].click()");
    tab().wait_until("document.querySelectorAll('#errors .said')[" + std::to_string(button) +
                     "].textContent === 'Copied'");
    const std::string copied = tab().value_of("navigator.clipboard.readText()");
    EXPECT_TRUE(copied.starts_with(std::string("Reference") + separator + "Column" + separator + "Series"))
        << copied;
    EXPECT_EQ(std::count(copied.begin(), copied.end(), '\n'), 7) << copied;
  }
  EXPECT_EQ(text_of(".command code"), "plumb run small.toml");
}

TEST_F(PageInBrowser, DataOfAFigureAreThoseOfItsFile) {
  open_run();
  chromium().call("Browser.setDownloadBehavior",
                  {{"behavior", "allow"}, {"downloadPath", file("downloads")}});
  EXPECT_EQ(count("figure.plot figcaption button"), 6);
  tab().value_of(
      "document.querySelector('figure.plot[data-file=\"figures/tip_plan.png\"] figcaption button').click()");
  const fs::path saved = file("downloads/tip_plan.csv");
  for (int k = 0; k < 60'000 && !fs::exists(saved); ++k)
    tab().value_of("new Promise((done) => setTimeout(done, 10))");
  const auto numbers_in = [](const std::string& text) {
    std::vector<double> numbers;
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "panel,kind,series,x,y,x_to,y_to,value");
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::string cell;
      while (std::getline(cells, cell, ',')) {
        char* end = nullptr;
        const double number = std::strtod(cell.c_str(), &end);
        if (end != cell.c_str() && *end == '\0') numbers.push_back(number);
      }
    }
    return numbers;
  };
  const std::vector<double> drawn = numbers_in(read_text(file("run/figures/tip_plan.csv")));
  EXPECT_GT(drawn.size(), 400U);
  EXPECT_EQ(numbers_in(read_text(saved)), drawn);
}

TEST_F(PageInBrowser, FitsWideAndNarrowWindows) {
  for (const char* page :
       {"run/index.html", "failed/index.html", "hostile.html", "index/index.html", "study/index.html"}) {
    tab().resize(360, 800);
    open(page);
    for (const int width : {360, 1400}) {
      tab().resize(width, 800);
      tab().wait_until("innerWidth === " + std::to_string(width));
      tab().value_of("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
      EXPECT_LE(tab().value_of("document.documentElement.scrollWidth").get<int>(), width) << page;
      EXPECT_EQ(tab().value_of("[...document.querySelectorAll('canvas')].filter((c) => "
                               "c.getBoundingClientRect().right > innerWidth).length"),
                0)
          << page << " " << width;
    }
  }
}

TEST_F(PageInBrowser, TextStandsOutInLightAndDark) {
  const std::string faint_texts = script("faint_texts.js");
  for (const char* page : {"run/index.html", "failed/index.html", "hostile.html", "index/index.html"}) {
    open(page);
    for (const char* scheme : {"light", "dark"}) {
      tab().emulate({{"prefers-color-scheme", scheme}, {"prefers-reduced-motion", "reduce"}});
      const Json texts = tab().value_of(faint_texts);
      EXPECT_GT(texts["seen"], 100) << page;
      EXPECT_EQ(texts["faint"], Json::array()) << page << " " << scheme;
      const Json paper = tab().value_of("getComputedStyle(document.body).backgroundColor");
      EXPECT_EQ(paper, std::string(scheme) == "dark" ? "rgb(18, 22, 29)" : "rgb(255, 255, 255)");
    }
  }
}

TEST_F(PageInBrowser, ShowsAllWithoutScripts) {
  tab().call("Emulation.setScriptExecutionDisabled", {{"value", true}});
  tab().emulate(Json::object());
  open_run();
  EXPECT_EQ(tab().value_of("typeof plumb"), "undefined") << "no script ran";
  EXPECT_EQ(count("figure.plot img"), 6);
  EXPECT_EQ(count("img.moving"), 1);
  EXPECT_EQ(count("img.still"), 0);
  EXPECT_EQ(count("tr[data-status]"), 6);
  EXPECT_EQ(count("button, canvas, select"), 0) << "what would do nothing";
  EXPECT_EQ(count(".command code"), 2);
  tab().emulate({{"prefers-reduced-motion", "reduce"}});
  EXPECT_EQ(count("img.moving"), 0);
  EXPECT_EQ(count("img.still"), 1);
}

TEST_F(PageInBrowser, PrintsTheDrawnPictures) {
  open_run();
  tab().emulate(Json::object(), "print");
  EXPECT_EQ(count("figure.plot img"), 6);
  EXPECT_EQ(count("canvas, button:not(.sort), select"), 0);
  EXPECT_EQ(count("img.still"), 1);
  tab().emulate(Json::object());
  const Json pdf = tab().call("Page.printToPDF", {{"printBackground", true}});
  const std::string data = pdf["data"];
  EXPECT_TRUE(data.starts_with("JVBERi0")) << "%PDF- in base64";
  EXPECT_GT(data.size(), 200000U) << "with its pictures";
  EXPECT_EQ(count("figure.plot canvas"), 8) << "the charts are back";
}

TEST_F(PageInBrowser, CanBeReadWithoutSeeing) {
  for (const char* page : {"run/index.html", "failed/index.html", "hostile.html", "index/index.html"}) {
    open(page);
    EXPECT_EQ(tab().value_of("[...document.images].filter((image) => image.alt.length < 10).length"), 0)
        << page;
    // Scripts draw, and describe, some of them once a picture is decoded.
    tab().wait_until(
        "[...document.querySelectorAll('canvas')].every((c) => c.getAttribute('role') && "
        "(c.getAttribute('aria-label') || '').trim())");
    const auto levels =
        tab()
            .value_of(
                "[...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].map((h) => Number(h.tagName[1]))")
            .get<std::vector<int>>();
    ASSERT_FALSE(levels.empty());
    EXPECT_EQ(levels.front(), 1);
    EXPECT_EQ(std::count(levels.begin(), levels.end(), 1), 1);
    for (std::size_t k = 1; k < levels.size(); ++k)
      EXPECT_LE(levels[k], levels[k - 1] + 1) << page << " heading " << k;
    for (const char* landmark : {"header", "main", "nav[aria-label]"})
      EXPECT_EQ(count(landmark), 1) << landmark;
    EXPECT_EQ(tab().value_of("[...document.querySelectorAll('button, select, input')].filter((control) => "
                             "!control.textContent.trim() && !control.labels.length && "
                             "!control.getAttribute('aria-label')).length"),
              0)
        << page;
    EXPECT_EQ(
        tab().value_of("(() => { const ids = [...document.querySelectorAll('[id]')].map((n) => n.id); return "
                       "ids.length - new Set(ids).size; })()"),
        0)
        << page;
  }
}

TEST_F(PageInBrowser, EveryControlIsReachedByTheTabKey) {
  open_run();
  const long controls =
      tab()
          .value_of(
              "[...document.querySelectorAll('a[href], button, select, input, summary, [tabindex=\"0\"]')]"
              ".filter((node) => node.checkVisibility()).length")
          .get<long>();
  tab().value_of(
      "window.reached = new Set(); document.addEventListener('focusin', (event) => "
      "reached.add(event.target))");
  for (long k = 0; k < controls; ++k) tab().press("Tab", tab_key);
  EXPECT_GT(controls, 60);
  EXPECT_EQ(
      tab().value_of("[...document.querySelectorAll('a[href], button, select, input, summary, "
                     "[tabindex=\"0\"]')].filter((node) => node.checkVisibility() && !reached.has(node))"
                     ".map((node) => node.outerHTML.slice(0, 80))"),
      Json::array());
}

TEST_F(PageInBrowser, OfAFailedRunBeginsWithWhatWentWrong) {
  open("failed/index.html");
  const std::string lead = text_of(".headline");
  EXPECT_EQ(
      lead.find("The 4-element run failed: it is unstable and ended at 0.0208 s of 2 s, so none of its 6 "
                "criteria could be judged."),
      0U)
      << lead;
  EXPECT_NE(lead.find("What went wrong: rk4 ended at t = 0.0208 s in step 16"), lead.npos) << lead;
  EXPECT_NE(lead.find("What would help: a step below 0.00104 s (tried to the end), or an implicit method."),
            lead.npos)
      << lead;
  EXPECT_LT(
      tab().value_of("document.querySelector('.headline').getBoundingClientRect().bottom").get<double>(),
      300);
  EXPECT_TRUE(tab().value_of("document.title").get<std::string>().starts_with("unstable: "));
  EXPECT_EQ(count(".verdict-group .tag.passed"), 0);
}

TEST_F(PageInBrowser, IndexFindsReportsByTextAndStatusAndShowsTheirComparisons) {
  open("index/index.html");
  EXPECT_EQ(tab().complaints(), std::vector<std::string>{});
  const auto shown = [&] { return std::pair(count(".card"), count(".verdict-group tr[data-status]")); };
  const std::pair<long, long> all(2, 12);
  EXPECT_EQ(shown(), all);
  EXPECT_GT(count("#comparisons svg circle"), 5);
  EXPECT_GT(count("#history svg"), 1);
  const auto set = [&](const std::string& selector, const std::string& value, const std::string& event) {
    tab().value_of("(() => { const node = document.querySelector('" + selector + "'); node.value = '" +
                   value + "'; node.dispatchEvent(new Event('" + event + "')); })()");
  };
  set(".filter-bar input", "unstable", "input");
  EXPECT_EQ(shown().first, 1);
  EXPECT_EQ(text_of(".card:not([hidden]) .name").substr(0, 6), "failed");
  set(".filter-bar input", "tip", "input");
  EXPECT_GT(shown().second, 0);
  EXPECT_LT(shown().second, all.second);
  set(".filter-bar input", "", "input");
  set(".filter-bar select", "validation", "change");
  EXPECT_LT(shown().second, all.second);
  set(".filter-bar select", "", "change");
  EXPECT_EQ(shown(), all);
  tab().call("Emulation.setScriptExecutionDisabled", {{"value", true}});
  open("index/index.html");
  EXPECT_EQ(count(".verdict-group tr[data-status]"), all.second) << "without scripts";
  EXPECT_EQ(count(".filter-bar"), 0);
  EXPECT_NE(text_of("noscript").find("Scripts are off here"), std::string::npos) << text_of("noscript");
}

TEST_F(PageInBrowser, BeginsWithVerdictsFiguresAndAnimationBesideAColumnOfContents) {
  open_run();
  const auto box = [&](const std::string& selector) {
    return tab().value_of("(() => { const b = document.querySelector('" + selector +
                          "').getBoundingClientRect(); return [b.left, b.top, b.right, b.bottom]; })()");
  };
  EXPECT_EQ(count(".marks .mark"), 4);
  EXPECT_EQ(text_of(".mark.passed").substr(0, 10), "Validation");
  EXPECT_EQ(count(".lead figure.plot"), 2);
  const Json first = box(".lead figure.plot"), moving = box("#animation"), contents = box(".contents"),
             main = box("main");
  EXPECT_LT(first[2].get<double>(), moving[0].get<double>()) << "abreast";
  EXPECT_LT(first[1].get<double>(), 500) << "what is seen first";
  EXPECT_LT(moving[1].get<double>(), 500);
  EXPECT_LE(contents[2].get<double>(), main[0].get<double>());
  tab().value_of("document.querySelector('#formulation').scrollIntoView()");
  tab().wait_until("document.querySelector('.contents [aria-current]')?.hash === '#formulation'");
  EXPECT_GE(box(".contents")[1].get<double>(), 0) << "it follows";
  const Json beside = tab().value_of(
      "(() => { const f = [...document.querySelectorAll('#figures figure')].map((n) => "
      "n.getBoundingClientRect()); return f[1].left > f[0].right && f[1].top === f[0].top; })()");
  EXPECT_EQ(beside, true) << "figures are two abreast";
  EXPECT_EQ(tab().value_of("[...document.querySelectorAll('.contents a, a.term')].filter((link) => "
                           "!document.querySelector(link.hash)).map((link) => link.hash)"),
            Json::array());
  EXPECT_GT(count("a.term"), 3);
  open("study/index.html");
  EXPECT_LE(box(".contents")[2].get<double>(), box("main")[0].get<double>()) << "of a study as well";
}

TEST_F(PageInBrowser, TwoReportsHaveTheirCurvesAndPicturesOverOneAnother) {
  open("index/index.html");
  EXPECT_EQ(tab().complaints(), std::vector<std::string>{});
  EXPECT_GT(tab().value_of("plumb.charts.length"), 1);
  EXPECT_EQ(tab().value_of("plumb.charts.every(({ panel }, k) => panel.series.length === 2 - k % 2)"), true);
  EXPECT_GT(count("figure.pair"), 2);
  EXPECT_EQ(count("figure.pair.sliding input[type=range]"), count("figure.pair"));
  tab().value_of(
      "(() => { const s = document.querySelector('figure.pair input'); s.value = 25; "
      "s.dispatchEvent(new Event('input')); })()");
  EXPECT_EQ(tab().value_of("getComputedStyle(document.querySelector('figure.pair img + img')).clipPath"),
            "inset(0px 0px 0px 25%)");
  EXPECT_GT(count("#beside tbody tr"), 8);
  tab().call("Emulation.setScriptExecutionDisabled", {{"value", true}});
  open("index/index.html");
  EXPECT_EQ(count("figure.pair input"), 0);
  EXPECT_EQ(tab().value_of("(() => { const [a, b] = document.querySelectorAll('figure.pair img'); return "
                           "a.getBoundingClientRect().right <= b.getBoundingClientRect().left; })()"),
            true)
      << "side by side without scripts";
}

TEST_F(PageInBrowser, OnPaperIsNumberedAndWholeWithoutControls) {
  open_run();
  tab().resize(680, 900);  // of A4 between its margins
  tab().emulate(Json::object(), "print");
  EXPECT_EQ(count("nav, select, input, .table-tools"), 0);
  EXPECT_EQ(tab().value_of("[...document.querySelectorAll('table')].filter((t) => t.getBoundingClientRect()"
                           ".right > innerWidth + 1).map((t) => t.caption.textContent)"),
            Json::array())
      << "no table is cut";
  EXPECT_EQ(tab().value_of("[...document.querySelectorAll('table')].every((t) => t.caption && "
                           "t.caption.checkVisibility() && t.caption.textContent.length > 2)"),
            true);
  EXPECT_EQ(tab().value_of("getComputedStyle(document.querySelector('figcaption'), '::before').content"),
            "\"Figure \" counter(figure) \". \"");
  EXPECT_EQ(tab().value_of("getComputedStyle(document.querySelector('caption'), '::before').content"),
            "\"Table \" counter(table) \". \"");
  EXPECT_EQ(tab().value_of("[...document.querySelectorAll('details:not([open]) > "
                           ":not(summary):not(.screen)')].filter((n) => !n.getBoundingClientRect().height)"
                           ".map((n) => n.outerHTML.slice(0, 80))"),
            Json::array())
      << "what is folded on the screen is open";
  EXPECT_EQ(count("#references li"), 4);
  EXPECT_GT(count("#glossary dt"), 3);
}

TEST_F(PageInBrowser, HasNothingThatAxeFinds) {
  // Where npm puts it in the source folder, or in one that NODE_PATH names.
  const char* node_path = std::getenv("NODE_PATH");
  std::string axe;
  for (const std::string& folder :
       {std::string(PLUMB_SOURCE_DIR) + "/node_modules", std::string(node_path != nullptr ? node_path : "")})
    if (const std::string file = folder + "/axe-core/axe.min.js"; axe.empty() && fs::exists(file)) axe = file;
  if (axe.empty()) GTEST_SKIP() << "axe-core is not installed; `npm install axe-core` in the source folder";
  for (const char* page : {"run/index.html", "failed/index.html", "index/index.html", "study/index.html"})
    for (const char* scheme : {"light", "dark"}) {
      tab().emulate({{"prefers-color-scheme", scheme}, {"prefers-reduced-motion", "reduce"}});
      open(page);
      tab().value_of(read_text(axe) + "; 0");
      EXPECT_EQ(tab().value_of("axe.run().then(({ violations }) => violations.map(({ id, nodes }) => `${id}: "
                               "${nodes.slice(0, 3).map((node) => node.html.slice(0, 120))}`))"),
                Json::array())
          << page << " " << scheme;
    }
}

}  // namespace
}  // namespace plumb
