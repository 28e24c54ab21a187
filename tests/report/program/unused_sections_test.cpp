#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace unused_sections_test {

/// A pendulum with this in it beside.
std::string with(const std::string& sections) {
  return "title = \"a\"\n[cable]\nlength = 1\narea = 25e-6\ndensity = 320\nyoungs_modulus = 1.6e6\n"
         "elements = 2\n[supports]\nfirst = \"pinned\"\n[loads]\ngravity = [0, -9.81, 0]\n[method]\nname = "
         "\"rk4\"\nstep = 1e-3\n[time]\nend = 0.1\noutput_interval = 0.02\n[[probe]]\nname = \"tip\"\nat = "
         "1\n" +
         sections;
}

constexpr const char* wrong_scene = "[scene]\nsize = [96, 54]\nframe_rate = 1e9\n";

TEST(UnusedSections, AReportIsMadeOfARunWhoseStudiesAreWrong) {
  for (const std::string wrong :
       {"[study.economy]\nwidths = [3]\n", "[study.work_precision]\nelements = [0]\n",
        "[study.sweep]\ncases = -1\n", "[study.stability]\nsteps = 1\n", "[uncertainty]\nsamples = 1\n",
        "[sensitivity]\nlargest = 1\n", "[[study.variant]]\nname = \"b\"\nset = { cable.length = -1 }\n"}) {
    const TemporaryFolder folder;
    write_text(folder / "a.toml", with("[scene]\nsize = [96, 54]\n" + wrong));
    const Ended solved = plumb_in(folder.path(), {"solve", "a.toml", "-o", "run"});
    ASSERT_EQ(solved.status, 0) << wrong << solved.err;
    EXPECT_NE(solved.err.find("is not used here"), std::string::npos) << wrong << solved.err;
    const Ended reported = plumb_in(folder.path(), {"report", "run", "-o", "report"});
    EXPECT_EQ(reported.status, 0) << wrong << reported.err;
    EXPECT_TRUE(fs::exists(folder / "report/frames/0000.png")) << wrong;
  }
}

TEST(UnusedSections, AReportOfARunWhoseSceneIsWrongHasNoFramesAndSaysWhy) {
  const TemporaryFolder folder;
  write_text(folder / "a.toml", with(wrong_scene));
  ASSERT_EQ(plumb_in(folder.path(), {"solve", "a.toml", "-o", "run"}).status, 0);
  const Ended reported = plumb_in(folder.path(), {"report", "run", "-o", "report"});
  EXPECT_EQ(reported.status, 0) << reported.err;
  const auto results = nlohmann::json::parse(read_text(folder / "report/results.json"));
  EXPECT_EQ(results.at("animation").at("frames"), 0);
  const std::string notes = results.at("animation").at("notes").dump();
  EXPECT_NE(notes.find("[scene] cannot be used: a.toml"), std::string::npos) << notes;
  EXPECT_TRUE(fs::exists(folder / "report/figures/energy.png"));
}

TEST(UnusedSections, RenderRefusesASceneThatIsWrongUnlessItIsMended) {
  const TemporaryFolder folder;
  write_text(folder / "a.toml", with(wrong_scene));
  ASSERT_EQ(plumb_in(folder.path(), {"solve", "a.toml", "-o", "run"}).status, 0);
  const Ended refused = plumb_in(folder.path(), {"render", "run", "-o", "pictures"});
  EXPECT_EQ(refused.status, 3) << refused.err;
  EXPECT_NE(refused.err.find("frame_rate"), std::string::npos) << refused.err;
  const Ended mended =
      plumb_in(folder.path(), {"render", "run", "-o", "pictures", "--set", "scene.frame_rate=25"});
  EXPECT_EQ(mended.status, 0) << mended.err;
  EXPECT_TRUE(fs::exists(folder / "pictures/frames/0002.png"));
}

}  // namespace unused_sections_test
}  // namespace plumb
