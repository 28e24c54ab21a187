#include <sys/stat.h>

#include <cstdlib>
#include <map>

#include "engine/base/errors.h"
#include "report/program/video.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace kept_files_test {

/// Commands among files of others, on a small case.
class KeptFiles : public ::testing::Test {
 protected:
  KeptFiles() {
    write_text(folder_ / "case.toml", read_text(case_path("pendulum.toml")));
    const std::string references = std::string(PLUMB_SOURCE_DIR) + "/cases/references";
    fs::copy(references, folder_ / "references");
  }

  Ended plumb(std::vector<std::string> arguments) { return plumb_in(folder_.path(), std::move(arguments)); }
  Ended plumb_below(const std::string& below, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), PLUMB_PROGRAM);
    fs::create_directories(folder_ / below);
    return run_command(arguments, folder_ / below);
  }
  Ended solve_into(const std::string& output, const std::string& end = "0.02") {
    return plumb({"solve", "case.toml", "-o", output, "--quiet", "--set", "time.end=" + end});
  }
  void solve(const std::string& output) {
    const Ended ended = solve_into(output);
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  /// That it ends with one line and this status, says these words, and changes nothing.
  void expect_refused(const std::vector<std::string>& arguments, int status, const std::string& words) {
    const auto before = everything();
    const Ended ended = plumb(arguments);
    EXPECT_EQ(ended.status, status) << ended.out << ended.err;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find(words), std::string::npos) << "'" << words << "' is not in: " << ended.err;
    EXPECT_TRUE(everything() == before) << "something changed with: " << ended.err;
  }
  std::map<std::string, std::string> everything() {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      if (entry.path() != folder_ / "stdout" && entry.path() != folder_ / "stderr")
        all[entry.path().string()] = entry.is_regular_file() ? read_text(entry.path()) : "";
    return all;
  }

  TemporaryFolder folder_;
};

TEST_F(KeptFiles, OfAFolderWithoutAManifestAreNotTouched) {
  write_text(folder_ / "thesis/thesis.txt", "years");
  write_text(folder_ / "thesis/docs/notes.txt", "more");
  solve("run");
  fs::copy_file(folder_ / "run/run.h5", folder_ / "thesis/run.h5");
  expect_refused({"report", "thesis/run.h5"}, 5, "it holds docs and no manifest.json");
  expect_refused({"render", "thesis"}, 5, "it holds docs and no manifest.json");
  expect_refused({"run", "case.toml", "-o", "."}, 5, "it holds case.toml and no manifest.json");
  expect_refused({"solve", "case.toml", "-o", "thesis"}, 5, "it holds docs and no manifest.json");
  expect_refused({"study", "case.toml", "-o", "thesis"}, 5, "it holds docs and no manifest.json");
  expect_refused({"diff", "thesis", "run", "--accept"}, 5, "it holds docs and no manifest.json");
}

TEST_F(KeptFiles, OfAnOutputFolderStay) {
  solve("out");
  write_text(folder_ / "out/case.toml", read_text(folder_ / "case.toml"));
  fs::copy(folder_ / "references", folder_ / "out/references");
  write_text(folder_ / "out/.git/HEAD", "ref: refs/heads/main");
  const Ended ended =
      plumb_below("out", {"solve", "case.toml", "-o", ".", "--quiet", "--set", "time.end=0.04"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(read_text(folder_ / "out/case.toml"), read_text(folder_ / "case.toml"));
  EXPECT_EQ(read_text(folder_ / "out/.git/HEAD"), "ref: refs/heads/main");
  EXPECT_NE(read_text(folder_ / "out/probes.csv").find("\n0.04"), std::string::npos);
}

TEST_F(KeptFiles, ThatWereChangedAreRefusedBeforeAnyWork) {
  solve("out");
  write_text(folder_ / "out/probes.csv", "my own remarks");
  // It would take minutes to solve.
  expect_refused({"run", "case.toml", "-o", "out", "--set", "time.end=200"}, 5,
                 "out/probes.csv: cannot be written: it was changed");
}

TEST_F(KeptFiles, AreThoseThatAreRead) {
  solve("out");
  write_text(folder_ / "given.toml",
             read_text(folder_ / "case.toml") +
                 "\n[[run]]\nname = \"given\"\nfile = \"out/probes.csv\"\ncolumns = { t = \"t\" }\n");
  fs::create_hard_link(folder_ / "case.toml", folder_ / "hard.csv");
  fs::create_symlink("case.toml", folder_ / "soft.csv");
  for (const char* name : {"case.toml", "hard.csv", "soft.csv"})
    expect_refused({"solve", "case.toml", "--csv", name}, 2,
                   std::string("--csv ") + name + ": is what is read");
  expect_refused({"solve", "case.toml", "-o", "out", "--csv", "out/run.h5"}, 2, "--csv out/run.h5");
  solve("other");
  expect_refused({"render", "out", "--beside", "other", "-o", "other"}, 2, "other/run.h5: is read");
  expect_refused({"diff", "out", "other", "--html", "other/probes.csv"}, 2, "--html other/probes.csv");
}

TEST_F(KeptFiles, SurviveTheAcceptingOfABaseline) {
  solve("a");
  fs::create_directory(folder_ / "a/sub");
  write_text(folder_ / "a/sub/probes.csv", "t [s]\n0\n");
  expect_refused({"diff", "a", "a/sub", "--accept"}, 2, "lies in a");
  expect_refused({"diff", "a/sub", "a", "--accept"}, 2, "lies in a");
  expect_refused({"diff", "a", "a/.", "--accept"}, 2, "are the same");
  fs::create_hard_link(folder_ / "a/probes.csv", folder_ / "same.csv");
  expect_refused({"diff", "a/probes.csv", "same.csv", "--accept"}, 2, "are the same");
  fs::remove(folder_ / "same.csv");
  ASSERT_EQ(solve_into("b", "0.04").status, 0);
  const Ended ended = plumb({"diff", "a", "b", "--accept"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(read_text(folder_ / "a/probes.csv"), read_text(folder_ / "b/probes.csv"));
  EXPECT_EQ(read_text(folder_ / "a/sub/probes.csv"), "t [s]\n0\n") << "it is not listed";
}

TEST_F(KeptFiles, AreThePagesThatAnIndexWouldOverwrite) {
  const Ended run = plumb({"run", "case.toml", "-o", "a", "--quiet", "--set", "time.end=0.04", "--set",
                           "scene.size=[16,16]", "--set", "scene.frame_rate=50", "--set", "study={}"});
  ASSERT_EQ(run.status, 1) << run.err;
  fs::copy(folder_ / "a", folder_ / "b", fs::copy_options::recursive);
  for (const char* name : {"index.html", "junit.xml", "summary.md", "results.json"}) {
    write_text(folder_ / "site" / name, "mine");
    expect_refused({"report", "a", "b", "-o", "site"}, 5,
                   std::string("site/") + name + ": cannot be written");
    fs::remove(folder_ / "site" / name);
  }
  write_text(folder_ / "site/about.html", "mine");
  EXPECT_EQ(plumb({"report", "a", "b", "-o", "site"}).status, 1);
  EXPECT_TRUE(fs::exists(folder_ / "site/manifest.json"));
  EXPECT_EQ(read_text(folder_ / "site/about.html"), "mine");
  expect_refused({"report", "a", "b", "-o", "a"}, 2, "a/results.json: is read");

  // What was drawn more often before goes, what is not ours stays.
  write_text(folder_ / "a/frames/note.txt", "mine");
  EXPECT_TRUE(fs::exists(folder_ / "a/frames/0001.png"));
  const Ended fewer = plumb({"render", "a", "--frames", "0"});
  EXPECT_EQ(fewer.status, 0) << fewer.err;
  EXPECT_FALSE(fs::exists(folder_ / "a/frames/0001.png"));
  EXPECT_TRUE(fs::exists(folder_ / "a/index.html"));
  EXPECT_EQ(read_text(folder_ / "a/frames/note.txt"), "mine");
}

/// Puts a script in the place of ffmpeg; its last argument is the file to write.
class KeptVideo : public KeptFiles {
 protected:
  KeptVideo() {
    if (const char* path = std::getenv("PATH")) path_ = path;
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
    write_text(folder_ / "clip.mp4", "the earlier one");
  }
  ~KeptVideo() override { ::setenv("PATH", path_.c_str(), 1); }

  /// Makes a video of two frames and returns what went wrong.
  std::string made_by(const std::string& script) {
    write_text(folder_ / "bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\n" + script);
    ::chmod((folder_ / "bin/ffmpeg").c_str(), 0755);
    try {
      Video video((folder_ / "clip.mp4").string(), 25);
      video.add("one");
      video.add("two");
      video.finish();
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  }

  std::string path_;
};

TEST_F(KeptVideo, IsReplacedOnlyByOneThatIsWhole) {
  const std::string failure =
      made_by("cat >/dev/null; echo half >\"$last\"; echo words >&2; echo \"$last: no room\" >&2; exit 1\n");
  EXPECT_NE(failure.find("clip.mp4: cannot be written: ffmpeg failed: clip.mp4: no room"), std::string::npos)
      << failure;
  EXPECT_EQ(read_text(folder_ / "clip.mp4"), "the earlier one");
  EXPECT_NE(made_by("cat >/dev/null\n").find("made no file"), std::string::npos);
  EXPECT_EQ(read_text(folder_ / "clip.mp4"), "the earlier one");
  EXPECT_EQ(made_by("cat >\"$last\"\n"), "");
  EXPECT_EQ(read_text(folder_ / "clip.mp4"), "onetwo");
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().string().find(".part-"), std::string::npos) << entry.path();
}

TEST_F(KeptVideo, IsMadeAgainWhereOneWasKilled) {
  const pid_t child = ::fork();
  if (child == 0) {
    made_by("echo half >\"$last\"; kill -9 $PPID; cat >/dev/null\n");
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << status;
  EXPECT_EQ(made_by("cat >\"$last\"\n"), "");
  EXPECT_EQ(read_text(folder_ / "clip.mp4"), "onetwo");
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().string().find("clip.mp4."), std::string::npos) << entry.path();
}

TEST_F(KeptFiles, AreThoseThatAStudysJournalLeadsTo) {
  write_text(folder_ / "precious.txt", "years");
  const std::vector<std::string> study{"study", "case.toml", "-o", "s"};
  fs::create_symlink("precious.txt", folder_ / "s.unfinished.jsonl");
  expect_refused(study, 5, "s.unfinished.jsonl: cannot be written: it is a link");
  fs::remove(folder_ / "s.unfinished.jsonl");
  fs::create_hard_link(folder_ / "precious.txt", folder_ / "s.unfinished.jsonl");
  expect_refused(study, 5, "s.unfinished.jsonl: cannot be written: it");
  fs::remove(folder_ / "s.unfinished.jsonl");
  write_text(folder_ / "s.unfinished.jsonl", "my own list");
  expect_refused(study, 5, "is no journal of a study");
  fs::remove(folder_ / "s.unfinished.jsonl");
  ASSERT_EQ(::mkfifo((folder_ / "s.unfinished.jsonl").c_str(), 0600), 0);
  expect_refused(study, 5, "it is no file");
}

TEST_F(KeptFiles, AreRunAndNumbersWhereThePicturesFail) {
  const std::vector<std::string> run{PLUMB_PROGRAM, "run",   "case.toml",     "-o",    "out",
                                     "--quiet",     "--set", "time.end=0.02", "--set", "scene.size=[16,16]"};
  // The fonts are opened before anything is solved, and again for the pictures.
  const auto with_fault = [&](int at) {
    std::vector<std::string> command{"env", "LD_PRELOAD=" PLUMB_FAULT_LIBRARY,
                                     "PLUMB_FAULT_UNDER=" PLUMB_FONTS, "PLUMB_FAULT_AT=" + std::to_string(at),
                                     "PLUMB_FAULT_ERROR=5"};
    command.insert(command.end(), run.begin(), run.end());
    return run_command(command, folder_.path());
  };
  const Ended before = with_fault(1);
  EXPECT_EQ(before.status, 5) << before.err;
  expect_one_line(before.err);
  EXPECT_FALSE(fs::exists(folder_ / "out")) << "nothing is solved that cannot be drawn";
  for (int at = 5; at < 12; ++at) {
    fs::remove_all(folder_ / "out");
    const Ended ended = with_fault(at);
    if (ended.status != 5 || !fs::exists(folder_ / "out")) continue;
    expect_one_line(ended.err);
    EXPECT_NE(ended.err.find("the run and its report without pictures are in"), std::string::npos)
        << ended.err;
    for (const char* name : {"run.h5", "probes.csv", "results.json", "index.html", "manifest.json"})
      EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
    EXPECT_EQ(plumb({"report", "out", "--quiet"}).status, 1) << "its pictures can be drawn later";
    EXPECT_TRUE(fs::exists(folder_ / "out/frames/0000.png"));
    return;
  }
  ADD_FAILURE() << "no drawing failed after the solving";
}

TEST_F(KeptFiles, ARendererThatIsNotThereIsFoundOutBeforeSolving) {
  const Ended ended = run_command(
      {"env", "PLUMB_GL=egl:99", PLUMB_PROGRAM, "run", "case.toml", "-o", "out", "--set", "time.end=200"},
      folder_.path());
  EXPECT_EQ(ended.status, 5) << ended.err;
  expect_one_line(ended.err);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 4)
      << "case, references, stdout, stderr";
}

}  // namespace kept_files_test
}  // namespace plumb
