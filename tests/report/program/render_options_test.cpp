#include <fmt/format.h>

#include <algorithm>

#include "render/image/png.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace render_options_test {

/// A run of eleven frames, made once.
class RenderOptions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<TemporaryFolder>();
    const Ended ended = plumb_in(
        folder->path(), {"solve", case_path("pendulum_published.toml"), "-o", "run", "--set", "time.end=0.1",
                         "--set", "scene.size=[64,36]", "--set", "scene.frame_rate=100"});
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  static void TearDownTestSuite() { folder.reset(); }

  static Ended render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"render", "run"});
    return plumb_in(folder->path(), arguments);
  }
  static std::unique_ptr<TemporaryFolder> folder;
};
std::unique_ptr<TemporaryFolder> RenderOptions::folder;

std::vector<std::string> pngs_in(const std::string& bytes) {
  const std::string signature = "\x89PNG\r\n\x1a\n";
  std::vector<std::string> result;
  for (std::size_t at = bytes.find(signature); at != std::string::npos;) {
    const std::size_t next = bytes.find(signature, at + 1);
    result.push_back(bytes.substr(at, next - at));
    at = next;
  }
  return result;
}

TEST_F(RenderOptions, SomeFramesKeepTheirNumbers) {
  const Ended ended = render({"-o", "some", "--frames", "3:5"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(*folder / "some/frames"))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"0003.png", "0004.png", "0005.png"}));
}

TEST_F(RenderOptions, SharesOfFramesFollowOneAnotherAndAreAllOfThem) {
  std::vector<std::string> names;
  for (const char* share : {"1/3", "2/3", "3/3"}) {
    const Ended ended = render({"--share", share});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::string frames = fmt::format("run.share-{}-of-3/frames", share[0]);
    std::vector<std::string> own;
    for (const auto& entry : fs::directory_iterator(*folder / frames)) own.push_back(entry.path().filename());
    std::sort(own.begin(), own.end());
    names.insert(names.end(), own.begin(), own.end());
  }
  std::vector<std::string> all;
  for (int k = 0; k < 11; ++k) all.push_back(fmt::format("{:04}.png", k));
  EXPECT_EQ(names, all);
  const Ended beyond = render({"--share", "12/12", "--frames", "0:3"});
  EXPECT_EQ(beyond.status, 0) << "the last of twelve has the last frame: " << beyond.err;
  EXPECT_EQ(render({"--share", "1/12", "--frames", "0:3"}).status, 2);
}

TEST_F(RenderOptions, StandardOutputGetsTheSameFramesOneAfterAnother) {
  ASSERT_EQ(render({"-o", "all"}).status, 0);
  const Ended ended = render({"-o", "-", "--frames", "9:"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::vector<std::string> frames = pngs_in(ended.out);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0], read_text(*folder / "all/frames/0009.png"));
  EXPECT_EQ(frames[1], read_text(*folder / "all/frames/0010.png"));
}

TEST_F(RenderOptions, SizeIsThatOfTheFrames) {
  const Ended ended = render({"-o", "-", "--frames", "0", "--size", "100x50"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Image image = decode_png(ended.out, "frame");
  EXPECT_EQ(image.width, 100);
  EXPECT_EQ(image.height, 50);
}

TEST_F(RenderOptions, KeysOfTheSceneCanBeSet) {
  const auto corner = [&](const std::string& theme) {
    const Ended ended = render({"-o", "-", "--frames", "0", "--set", "scene.theme=" + theme});
    EXPECT_EQ(ended.status, 0) << ended.err;
    return static_cast<int>(decode_png(ended.out, theme).rgb.at(0));
  };
  EXPECT_GT(corner("light"), 200);
  EXPECT_LT(corner("dark"), 60);
}

TEST_F(RenderOptions, BadOnesAreRefusedInOneLineAndNothingIsWritten) {
  for (const auto& [arguments, status] :
       std::vector<std::pair<std::vector<std::string>, int>>{{{"--frames", "11:12"}, 2},
                                                             {{"--frames", "5:3"}, 2},
                                                             {{"--frames", "-1:3"}, 2},
                                                             {{"--frames", "1:2:3"}, 2},
                                                             {{"--frames", "x"}, 2},
                                                             {{"--frames", "0:11"}, 2},
                                                             {{"--size", "0x0"}, 2},
                                                             {{"--size", "100"}, 2},
                                                             {{"--size", "100x"}, 2},
                                                             {{"--size", "1x1"}, 2},
                                                             {{"--camera", "nowhere"}, 2},
                                                             {{"--set", "cable.elements=8"}, 2},
                                                             {{"--set", "scene"}, 2},
                                                             {{"--set", "scene.theme=blue"}, 3},
                                                             {{"--set", "scene.thme=dark"}, 3},
                                                             {{"--video", "a.avi"}, 2}}) {
    std::vector<std::string> all{"-o", "bad"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ended ended = render(all);
    EXPECT_EQ(ended.status, status) << testing::PrintToString(arguments) << ended.err;
    expect_one_line(ended.err);
    EXPECT_FALSE(fs::exists(*folder / "bad")) << testing::PrintToString(arguments);
  }
}

TEST_F(RenderOptions, VideoWithoutFfmpegIsRefusedByThatReason) {
  const Ended ended = run_command(
      {"/usr/bin/env", "PATH=/nowhere", PLUMB_PROGRAM, "render", "run", "-o", "bad", "--video", "a.mp4"},
      folder->path());
  EXPECT_EQ(ended.status, 5);
  EXPECT_NE(ended.err.find("ffmpeg, which is not installed"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(*folder / "bad"));
}

TEST_F(RenderOptions, VideoHasTheFramesWhereFfmpegIsThere) {
  if (run_command({"ffmpeg", "-version"}, folder->path()).status != 0)
    GTEST_SKIP() << "ffmpeg is not installed";
  for (const char* file : {"a.mp4", "a.webm"}) {
    const Ended ended = render({"-o", "filmed", "--video", file});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Ended frames = run_command({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                      "stream=nb_read_frames", "-of", "csv=p=0", file},
                                     folder->path());
    EXPECT_EQ(std::stoi(frames.out), 11) << file;
  }
}

TEST_F(RenderOptions, VideoThatFfmpegCannotWriteLeavesNothing) {
  if (run_command({"ffmpeg", "-version"}, folder->path()).status != 0)
    GTEST_SKIP() << "ffmpeg is not installed";
  const Ended ended = render({"-o", "bad", "--video", "no/such/folder/a.mp4"});
  EXPECT_EQ(ended.status, 5);
  EXPECT_FALSE(fs::exists(*folder / "bad"));
}

}  // namespace render_options_test
}  // namespace plumb
