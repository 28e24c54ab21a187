#include "engine/run/output_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"
#include "engine/base/put_in_place.h"
#include "engine/base/sha256.h"

namespace plumb {
namespace output_folder_test {

namespace fs = std::filesystem;

std::string text_at(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void put(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

class OutputFolderTest : public ::testing::Test {
 protected:
  OutputFolderTest() {
    std::string name = (fs::temp_directory_path() / "plumb-folder-XXXXXX").string();
    root_ = fs::canonical(::mkdtemp(name.data()));
  }
  ~OutputFolderTest() override {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }

  using Files = std::map<std::string, std::string>;

  void write(const Files& files, const FolderUse& use = {}) {
    OutputFolder folder((root_ / "out").string(), use);
    for (const auto& [name, text] : files) folder.write(name, text);
    folder.commit();
  }

  /// What is in the folder beside its manifest.
  Files found() const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(root_ / "out"))
      if (!entry.is_directory() && entry.path().filename() != manifest_name)
        files[entry.path().lexically_relative(root_ / "out").generic_string()] = text_at(entry.path());
    return files;
  }

  /// That writing these files is refused before anything is done, with these words.
  void expect_refused(const std::string& words, const FolderUse& use = {}) {
    std::vector<std::string> before = everything();
    try {
      OutputFolder folder((root_ / "out").string(), use);
      ADD_FAILURE() << "it is not refused";
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
    EXPECT_EQ(everything(), before);
  }

  std::vector<std::string> everything() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(root_)) names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  /// A manifest as somebody might write one.
  void forge(const std::string& files, const std::string& rest = "") {
    put(root_ / "out" / manifest_name, "{\"plumb_manifest\": 1, \"files\": [" + files + "]" + rest + "}");
  }
  static std::string entry(const std::string& name, const std::string& text) {
    return "{\"name\": \"" + name + "\", \"size\": " + std::to_string(text.size()) + ", \"sha256\": \"" +
           sha256(text) + "\"}";
  }

  fs::path root_;
  const Files run_{{"run.h5", "states"}, {"probes.csv", "numbers"}, {"frames/0000.png", "first"}};
};

TEST(Sha256, IsThatOfItsStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(OutputFolderTest, IsThereAsAWholeWithAManifest) {
  write(run_);
  EXPECT_EQ(found(), run_);
  const FolderSurvey survey = look_into((root_ / "out").string(), FolderContent::results);
  EXPECT_EQ(survey.manifest.manifest.files.size(), 3U);
  EXPECT_EQ(survey.manifest.manifest.files.at("run.h5"), (ListedFile{6, sha256("states")}));
  EXPECT_TRUE(survey.others.empty());
}

TEST_F(OutputFolderTest, IsReplacedAsAWholeWhereAllOfItIsOurs) {
  write(run_);
  struct stat before {
  }, after{};
  ::stat((root_ / "out").c_str(), &before);
  write({{"run.h5", "other"}});
  ::stat((root_ / "out").c_str(), &after);
  EXPECT_EQ(found(), (Files{{"run.h5", "other"}}));
  EXPECT_NE(before.st_ino, after.st_ino) << "it was not exchanged in one step";
  EXPECT_EQ(everything().size(), 3U) << "something was left beside it";
}

TEST_F(OutputFolderTest, KeepsItsPermissions) {
  write(run_);
  ::chmod((root_ / "out").c_str(), 0750);
  write(run_);
  struct stat status {};
  ::stat((root_ / "out").c_str(), &status);
  EXPECT_EQ(status.st_mode & 07777, 0750U);
}

TEST_F(OutputFolderTest, KeepsFilesOfOthers) {
  write(run_);
  put(root_ / "out/thesis.txt", "years of work");
  put(root_ / "out/frames/mine.txt", "mine");
  put(root_ / "out/.git/HEAD", "ref");
  fs::create_directory(root_ / "out/empty");
  fs::create_symlink("/etc", root_ / "out/link");
  write({{"run.h5", "other"}, {"figures/a.png", "new"}});
  EXPECT_EQ(text_at(root_ / "out/thesis.txt"), "years of work");
  EXPECT_EQ(text_at(root_ / "out/frames/mine.txt"), "mine");
  EXPECT_EQ(text_at(root_ / "out/.git/HEAD"), "ref");
  EXPECT_TRUE(fs::is_directory(root_ / "out/empty"));
  EXPECT_TRUE(fs::is_symlink(root_ / "out/link"));
  EXPECT_EQ(text_at(root_ / "out/run.h5"), "other");
  EXPECT_FALSE(fs::exists(root_ / "out/frames/0000.png")) << "what is ours and no longer made goes";
  EXPECT_FALSE(fs::exists(root_ / "out/probes.csv"));
  write(run_);
  EXPECT_FALSE(fs::exists(root_ / "out/figures")) << "a folder of ours that is empty goes";
  EXPECT_EQ(text_at(root_ / "out/thesis.txt"), "years of work");
}

TEST_F(OutputFolderTest, IsKeptInPlaceWhereTheProgramStandsInIt) {
  write(run_);
  struct stat before {
  }, after{};
  ::stat((root_ / "out").c_str(), &before);
  const fs::path here = fs::current_path();
  fs::current_path(root_ / "out/frames");
  write({{"run.h5", "other"}, {"frames/0000.png", "second"}});
  fs::current_path(here);
  ::stat((root_ / "out").c_str(), &after);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(found(), (Files{{"run.h5", "other"}, {"frames/0000.png", "second"}}));
}

TEST_F(OutputFolderTest, WithoutAManifestIsRefusedByTheFirstFileInIt) {
  put(root_ / "out/run.h5", "of an earlier version, or of somebody else");
  put(root_ / "out/case.toml", "mine");
  expect_refused("out: cannot be written: it holds case.toml and no manifest.json");
}

TEST_F(OutputFolderTest, WithAFileThatWasChangedIsRefusedByIt) {
  write(run_);
  put(root_ / "out/probes.csv", "numberS");
  expect_refused("out/probes.csv: cannot be written: it was changed since");
}

TEST_F(OutputFolderTest, WithANameTakenByAnotherIsRefusedByIt) {
  write({{"run.h5", "states"}});
  for (const char* name : {"index.html", "frames/0007.png", "figures/x.png", "figures", "frames"}) {
    put(root_ / "out" / name, "mine");
    expect_refused(std::string("out/") + name + ": cannot be written: that name is taken");
    fs::remove_all(root_ / "out" / name);
    fs::remove(root_ / "out/figures");
    fs::remove(root_ / "out/frames");
  }
  put(root_ / "out/index.html", "mine");
  write({{"run.h5", "other"}}, {.content = FolderContent::run});
  EXPECT_EQ(text_at(root_ / "out/index.html"), "mine");
}

TEST_F(OutputFolderTest, DoesNotWriteThroughALink) {
  write(run_);
  put(root_ / "elsewhere/0000.png", "first");
  fs::remove_all(root_ / "out/frames");
  fs::create_directory_symlink("../elsewhere", root_ / "out/frames");
  expect_refused("out/frames: cannot be written");
  fs::remove(root_ / "out/frames");
  fs::remove(root_ / "out/run.h5");
  put(root_ / "target", "states");
  fs::create_symlink("../target", root_ / "out/run.h5");
  expect_refused("out/run.h5: cannot be written");
  EXPECT_EQ(text_at(root_ / "target"), "states");
}

TEST_F(OutputFolderTest, WithAManifestThatIsNoneIsRefused) {
  const std::string good = entry("run.h5", "states"), sum = sha256("");
  const std::pair<std::string, std::string> faults[] = {
      {"", "none of Plumb"},
      {"[]", "none of Plumb"},
      {std::string(100000, '['), "none of Plumb"},
      {"{\"plumb_manifest\": 2, \"files\": []}", "another version"},
      {"{\"plumb_manifest\": \"1\", \"files\": []}", "another version"},
      {"{\"plumb_manifest\": 1}", "no list"},
      {"{\"plumb_manifest\": 1, \"files\": {}}", "no list"},
      {"{\"plumb_manifest\": 1, \"files\": [3]}", "no file"},
      {"{\"plumb_manifest\": 1, \"files\": [" + good + "," + good + "]}", "twice"},
      {"{\"plumb_manifest\": 1, \"files\": [" + good + "]", "none of Plumb"},
      {"{\"plumb_manifest\": 1, \"files\": [{\"name\": \"a\", \"size\": -1, \"sha256\": \"" + sum + "\"}]}",
       "no file"},
      {"{\"plumb_manifest\": 1, \"files\": [{\"name\": \"a\", \"size\": 1e3, \"sha256\": \"" + sum + "\"}]}",
       "no file"},
      {"{\"plumb_manifest\": 1, \"files\": [{\"name\": \"a\", \"size\": 0, \"sha256\": \"abc\"}]}",
       "no file"},
      {"{\"plumb_manifest\": 1, \"files\": [{\"name\": 1, \"size\": 0, \"sha256\": \"" + sum + "\"}]}",
       "no file"},
  };
  for (const auto& [text, words] : faults) {
    put(root_ / "out" / manifest_name, text);
    put(root_ / "out/run.h5", "states");
    SCOPED_TRACE(text.substr(0, 200));
    expect_refused(words);
  }
  for (const char* name :
       {"../victim", "/etc/passwd", "a/../../victim", "./run.h5", "a//b", "a/", "", "..", "manifest.json"}) {
    forge(entry(name, ""));
    SCOPED_TRACE(name);
    expect_refused("lists a name that no file of an output folder has");
  }
  fs::remove(root_ / "out" / manifest_name);
  put(root_ / "true.json", "{\"plumb_manifest\": 1, \"files\": [" + good + "]}");
  fs::create_symlink("../true.json", root_ / "out" / manifest_name);
  expect_refused("manifest.json: cannot be written: it is no regular file");
}

TEST_F(OutputFolderTest, RemovesNothingThatAForgedManifestListsWrongly) {
  put(root_ / "out/case.toml", "mine");
  put(root_ / "victim/0000.png", "first");
  fs::create_directory_symlink("../victim", root_ / "out/link");
  forge(entry("case.toml", "mine") + "," + entry("link/0000.png", "first"));
  write({{"run.h5", "new"}}, {.content = FolderContent::run});
  EXPECT_EQ(text_at(root_ / "out/case.toml"), "mine") << "no file that Plumb makes has that name";
  EXPECT_EQ(text_at(root_ / "victim/0000.png"), "first");
}

TEST_F(OutputFolderTest, IsRefusedWhereAFileThatIsReadWouldBeReplaced) {
  write(run_);
  fs::create_hard_link(root_ / "out/probes.csv", root_ / "other_name.csv");
  EXPECT_THROW(OutputFolder((root_ / "out").string(), {.reads = {(root_ / "other_name.csv").string()}}),
               UsageError);
  fs::create_symlink(root_ / "out/run.h5", root_ / "link.h5");
  EXPECT_THROW(OutputFolder((root_ / "out").string(), {.reads = {(root_ / "link.h5").string()}}), UsageError);
  EXPECT_EQ(found(), run_);
}

TEST_F(OutputFolderTest, LeavesASourceThatIsNotOursAsItIs) {
  put(root_ / "out/run.h5", "given by somebody");
  write({{"run.h5", "again"}, {"index.html", "page"}}, {.sources = {(root_ / "out/run.h5").string()}});
  EXPECT_EQ(found(), (Files{{"run.h5", "given by somebody"}, {"index.html", "page"}}));
  put(root_ / "out/thesis.txt", "years");
  write({{"run.h5", "again"}, {"index.html", "second"}}, {.sources = {(root_ / "out/run.h5").string()}});
  EXPECT_EQ(text_at(root_ / "out/run.h5"), "given by somebody");
  EXPECT_EQ(text_at(root_ / "out/index.html"), "second");
}

TEST_F(OutputFolderTest, KeepsWhatCameIntoItMeanwhile) {
  write(run_);
  {
    OutputFolder folder((root_ / "out").string());
    folder.write("run.h5", "other");
    put(root_ / "out/note.txt", "written while it was solving");
    folder.commit();
  }
  EXPECT_EQ(found(), (Files{{"run.h5", "other"}, {"note.txt", "written while it was solving"}}));
  std::string said;
  {
    OutputFolder folder((root_ / "out").string());
    folder.write("run.h5", "third");
    put(root_ / "out/run.h5", "mine now");
    try {
      folder.commit();
    } catch (const OutputError& error) {
      said = error.what();
    }
  }
  EXPECT_EQ(text_at(root_ / "out/run.h5"), "mine now");
  EXPECT_NE(said.find("out/run.h5: cannot be written: it was changed"), std::string::npos) << said;
  EXPECT_NE(said.find("what was made is in " + (root_ / "out.new").string()), std::string::npos) << said;
  EXPECT_EQ(text_at(root_ / "out.new/run.h5"), "third");
}

TEST_F(OutputFolderTest, IsNotPutOverAManifestThatCameOrChangedMeanwhile) {
  const auto refused = [&](const std::string& what, const std::function<void()>& meanwhile) {
    std::string said;
    {
      OutputFolder folder((root_ / "out").string());
      folder.write("run.h5", "new");
      meanwhile();
      try {
        folder.commit();
      } catch (const OutputError& error) {
        said = error.what();
      }
    }
    EXPECT_NE(said.find("manifest.json"), std::string::npos) << what << ": " << said;
    EXPECT_EQ(text_at(root_ / "out.new/run.h5"), "new") << what;
    fs::remove_all(root_ / "out.new");
  };
  refused("a file", [&] { put(root_ / "out/manifest.json", "{\"name\":\"my web app\"}"); });
  EXPECT_EQ(text_at(root_ / "out/manifest.json"), "{\"name\":\"my web app\"}");
  fs::remove_all(root_ / "out");
  refused("a folder", [&] { put(root_ / "out/manifest.json/thesis.tex", "precious"); });
  EXPECT_EQ(text_at(root_ / "out/manifest.json/thesis.tex"), "precious");
  fs::remove_all(root_ / "out");
  write(run_);
  std::string edited;
  refused("our own, edited", [&] {
    edited = text_at(root_ / "out/manifest.json") + "\n";
    put(root_ / "out/manifest.json", edited);
  });
  EXPECT_EQ(text_at(root_ / "out/manifest.json"), edited);
}

TEST_F(OutputFolderTest, LeavesWhatOthersPutIntoItsTemporaryFolder) {
  {
    OutputFolder folder((root_ / "out").string());
    folder.write("run.h5", "unfinished");
    for (const auto& entry : fs::directory_iterator(root_))
      if (entry.path().filename().string().starts_with(".out.part-")) put(entry.path() / "mine", "precious");
  }
  EXPECT_EQ(text_at(root_ / "out.new/mine"), "precious");
  EXPECT_FALSE(fs::exists(root_ / "out.new/run.h5"));
}

TEST_F(OutputFolderTest, BesideOthersNeedsNoManifest) {
  put(root_ / "out/README.md", "mine");
  write({{"index.html", "index"}}, {.content = FolderContent::pages, .beside_others = true});
  write({{"index.html", "again"}}, {.content = FolderContent::pages, .beside_others = true});
  EXPECT_EQ(found(), (Files{{"index.html", "again"}, {"README.md", "mine"}}));
}

TEST_F(OutputFolderTest, KeepsItsOtherFilesWhereItIsAddedTo) {
  write(run_);
  write({{"index.html", "page"}}, {.content = FolderContent::pages, .adds = true});
  Files all = run_;
  all["index.html"] = "page";
  EXPECT_EQ(found(), all);
  const FolderSurvey survey = look_into((root_ / "out").string(), FolderContent::results);
  EXPECT_EQ(survey.ours.size(), 4U);
  EXPECT_TRUE(survey.others.empty());
}

TEST_F(OutputFolderTest, AfterAKilledCommandTakesEitherFileForOurs) {
  put(root_ / "out/run.h5", "new");
  put(root_ / "out/probes.csv", "old numbers");
  put(root_ / "out/mine.txt", "mine");
  forge(entry("run.h5", "old") + "," + entry("probes.csv", "old numbers"),
        ", \"next\": [" + entry("run.h5", "new") + "," + entry("probes.csv", "new numbers") + "]");
  std::vector<std::string> remarks;
  write({{"run.h5", "third"}}, {.remark = [&](const std::string& text) { remarks.push_back(text); }});
  EXPECT_EQ(found(), (Files{{"run.h5", "third"}, {"mine.txt", "mine"}}));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("killed"), std::string::npos);
}

TEST_F(OutputFolderTest, ClearsWhatKilledCommandsLeft) {
  std::vector<pid_t> children;
  for (int k = 0; k < 3; ++k) {
    children.push_back(::fork());
    if (children.back() == 0) {
      OutputFolder folder((root_ / "out").string());
      folder.write("frames/0000.png", "half");
      for (;;) ::pause();
    }
    // Each has a mark, the folder to be, one in it and a file there.
    for (int wait = 0; wait < 60'000 && everything().size() < 5U * children.size(); ++wait) ::usleep(1000);
  }
  ASSERT_EQ(everything().size(), 15U);
  for (const pid_t child : children) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  std::vector<std::string> remarks;
  write(run_, {.remark = [&](const std::string& text) { remarks.push_back(text); }});
  EXPECT_EQ(everything().size(), 6U);
  ASSERT_EQ(remarks.size(), 1U) << "in one line";
  EXPECT_NE(remarks[0].find("3 earlier commands"), std::string::npos) << remarks[0];
}

TEST_F(OutputFolderTest, ClearsNoFolderOfAnotherOrOneInUse) {
  OutputFolder running((root_ / "out").string());
  running.write("run.h5", "half");
  std::string mark;
  for (const auto& entry : fs::directory_iterator(root_)) mark = text_at(entry.path() / ".plumb-part");
  ASSERT_NE(mark, "");
  put(root_ / ".out.part-abcdef/thesis.txt", "no mark");
  put(root_ / ".out.part-ghijkl/run.h5", "a copied mark");
  put(root_ / ".out.part-ghijkl/.plumb-part", mark);
  put(root_ / "victim/run.h5", "behind a link");
  fs::create_directory_symlink("victim", root_ / ".out.part-mnopqr");
  const std::vector<std::string> before = everything();
  { OutputFolder second((root_ / "out").string()); }
  EXPECT_EQ(everything(), before);
  running.commit();
  EXPECT_EQ(found(), (Files{{"run.h5", "half"}}));
}

TEST_F(OutputFolderTest, LeavesInAKilledCommandsFolderWhatIsNotOurs) {
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFolder folder((root_ / "out").string());
    folder.write("run.h5", "half");
    for (const auto& entry : fs::directory_iterator(root_)) put(entry.path() / "note.txt", "mine");
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  write(run_);
  std::string found_text;
  for (const auto& entry : fs::recursive_directory_iterator(root_))
    if (entry.path().filename() == "note.txt") found_text = text_at(entry.path());
  EXPECT_EQ(found_text, "mine");
}

TEST_F(OutputFolderTest, KeepsWhatCameIntoItInTheLastMoment) {
  write(run_);
  const FolderSurvey survey = look_into((root_ / "out").string(), FolderContent::results);
  put(root_ / "out/note.txt", "mine");
  put(root_ / "out/frames/more/note.txt", "mine too");
  put(root_ / "out/probes.csv", "edited");
  PartFolder part(root_.string(), "out");
  const Descriptor file = part.create("new/probes.csv");
  ASSERT_EQ(::write(file.get(), "fresh", 5), 5);
  const ListedFiles written{{"probes.csv", {5, sha256("fresh")}}};
  part.own(written, "new/");
  const Descriptor made = open_folder(part.path() + "/new");
  ASSERT_TRUE(
      put_at_once({part, made.get(), (root_ / "out").string(), written, survey.manifest.text, survey.ours},
                  survey.folder));
  EXPECT_EQ(found(),
            (Files{{"probes.csv", "fresh"}, {"note.txt", "mine"}, {"frames/more/note.txt", "mine too"}}));
  const std::string left = part.clear();
  EXPECT_EQ(left, (root_ / "out.new/new/probes.csv").string()) << "its name is taken by the new one";
  EXPECT_EQ(text_at(left), "edited");
  for (const std::string& name : everything()) EXPECT_EQ(name.find(".part-"), std::string::npos) << name;
}

TEST_F(OutputFolderTest, InItsPlaceIsNotTakenForALeftoverWhateverItIsCalled) {
  write(run_);
  fs::rename(root_ / "out", root_ / ".out.part-backup");
  write({{"run.h5", "other"}});
  EXPECT_EQ(text_at(root_ / ".out.part-backup/run.h5"), "states");
  EXPECT_EQ(text_at(root_ / ".out.part-backup/frames/0000.png"), "first");
}

/// Leaves what a program that is killed with a signal, or ends by one, has made so far.
template <typename Work>
int status_of_child(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

TEST_F(OutputFolderTest, EndedFromOutsideLeavesNothingOfOursAndAllOfOthers) {
  const int status = status_of_child([&] {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDERR_FILENO);
    catch_interrupts();
    OutputFolder folder((root_ / "out").string(), {.content = FolderContent::copies});
    folder.write("sub/a.csv", "half");
    OutputFolder alone((root_ / "alone").string());
    alone.write("run.h5", "half");
    for (const auto& entry : fs::directory_iterator(root_))
      if (entry.path().filename().string().starts_with(".out.part-"))
        put(entry.path() / "new/sub/mine", "precious");
    std::raise(SIGTERM);
    for (;;) ::pause();
  });
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root_))
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(root_).generic_string());
  EXPECT_EQ(files, std::vector<std::string>{"out.new/new/sub/mine"});
}

TEST_F(OutputFolderTest, WhatWasKilledIsClearedByTheNextFileOfItsName) {
  for (const bool marked : {true, false}) {
    status_of_child([&] {
      PartFolder part(root_.string(), "t.csv");
      if (marked) part.own("t.csv");
      put(fs::path(part.path()) / "t.csv", "half");
      ::_exit(0);
    });
    ASSERT_EQ(everything().size(), 3U);
    write_file((root_ / "t.csv").string(), "whole");
    EXPECT_EQ(text_at(root_ / "t.csv"), "whole");
    if (marked) {
      EXPECT_EQ(everything().size(), 1U);
    } else {
      EXPECT_EQ(text_at(root_ / "t.csv.new/t.csv"), "half") << "it was not said that it is ours";
    }
    for (const std::string& name : everything()) fs::remove_all(name);
  }
}

TEST_F(OutputFolderTest, AtALinkToNothingSaysSo) {
  fs::create_symlink("nowhere", root_ / "out");
  expect_refused("out: cannot be written: it is a link to nothing, nowhere");
}

TEST_F(OutputFolderTest, TakesOverOnlyWhatIsOurs) {
  write({{"run.h5", "states"}, {"choice.json", "{}"}});
  OutputFolder folder((root_ / "out").string());
  folder.keep("choice.json");
  folder.keep("summary.md");
  folder.write("run.h5", "again");
  folder.commit();
  EXPECT_EQ(found(), (Files{{"run.h5", "again"}, {"choice.json", "{}"}}));
}

TEST_F(OutputFolderTest, HasNoFilesOfOtherNames) {
  OutputFolder folder((root_ / "out").string());
  for (const char* name :
       {"../x", "/tmp/x", "thesis.txt", "manifest.json", "frames/a.png", "figures/a/b.png"})
    EXPECT_THROW(folder.write(name, "x"), std::logic_error) << name;
}

TEST_F(OutputFolderTest, WritesASingleFileAtTheEndOfALink) {
  put(root_ / "data/real.csv", "old");
  ::chmod((root_ / "data/real.csv").c_str(), 0600);
  fs::create_symlink("data/real.csv", root_ / "link.csv");
  write_file((root_ / "link.csv").string(), "new");
  EXPECT_TRUE(fs::is_symlink(root_ / "link.csv"));
  EXPECT_EQ(text_at(root_ / "data/real.csv"), "new");
  struct stat status {};
  ::stat((root_ / "data/real.csv").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0600U) << "a private file stays private";
  EXPECT_EQ(std::distance(fs::directory_iterator(root_ / "data"), {}), 1) << "nothing is left beside it";
  write_file("/dev/null", "nothing");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  try {
    write_file("/dev/full", "x");
    ADD_FAILURE() << "a full device takes nothing";
  } catch (const WriteError& error) {
    EXPECT_STREQ(error.what(), "/dev/full: cannot be written: No space left on device");
  }
}

}  // namespace output_folder_test
}  // namespace plumb
