#include "engine/base/side_by_side.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

namespace plumb {
namespace side_by_side_test {

constexpr const char* diary = "PLUMB_SIDE_BY_SIDE_DIARY";

void note(const std::string& line) {
  const int file = ::open(std::getenv(diary), O_WRONLY | O_APPEND | O_CREAT, 0600);
  EXPECT_EQ(::write(file, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  ::close(file);
}

// What this program does where it is run by the tests below.
TEST(SideBySideChild, DISABLED_Lasts) {
  note("+");
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  note("-");
}
TEST(SideBySideChild, DISABLED_Crashes) {
  ::raise(SIGSEGV);
}
TEST(SideBySideChild, DISABLED_EndsWithSeven) {
  std::fputs("seven it is\n", stderr);
  ::_exit(7);
}

OwnRun child(const std::string& name, double memory = 1, bool alone = false) {
  return {
      {"--gtest_also_run_disabled_tests", "--gtest_filter=SideBySideChild.DISABLED_" + name}, memory, alone};
}

class SideBySide : public ::testing::Test {
 protected:
  SideBySide() {
    ::close(::mkstemp(file_.data()));
    ::setenv(diary, file_.c_str(), 1);
  }
  ~SideBySide() override { std::filesystem::remove(file_); }

  std::map<std::size_t, OwnRunEnd> run(const std::vector<OwnRun>& runs, double memory = 100) {
    std::map<std::size_t, OwnRunEnd> ends;
    run_side_by_side(
        runs, memory,
        [&](std::size_t k, const OwnRunEnd& end) { EXPECT_TRUE(ends.emplace(k, end).second) << k; },
        [] { ADD_FAILURE() << "nobody asked to stop"; });
    return ends;
  }

  /// How many lasted at once, at most.
  int most_at_once() const {
    std::ifstream file(file_);
    int now = 0, most = 0;
    for (char c; file.get(c);) most = std::max(most, now += c == '+' ? 1 : -1);
    return most;
  }

  std::string file_ = (std::filesystem::temp_directory_path() / "plumb-diary-XXXXXX").string();
};

TEST_F(SideBySide, OneThatCrashesTakesNoOtherWithItAndEachTellsHowItEnded) {
  const auto ends = run({child("Lasts"), child("Crashes"), child("EndsWithSeven"), child("Lasts")});
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_EQ(ends.at(0).status, 0) << ends.at(0).fault;
  EXPECT_EQ(ends.at(3).status, 0) << ends.at(3).fault;
  EXPECT_EQ(ends.at(1).fault, "crashed (signal 11)");
  EXPECT_EQ(ends.at(2).status, 7);
  EXPECT_EQ(ends.at(2).errors, "seven it is\n");
  EXPECT_GT(ends.at(0).seconds, 0.05);
}

TEST_F(SideBySide, AsManyAsThereAreProcessorsRunAtOnce) {
  run(std::vector<OwnRun>(side_by_side() + 2, child("Lasts")));
  EXPECT_LE(most_at_once(), static_cast<int>(side_by_side()));
}

TEST_F(SideBySide, NoMoreRunThanThereIsMemoryForButAlwaysOne) {
  EXPECT_EQ(run({child("Lasts", 60), child("Lasts", 60), child("Lasts", 200)}, 100).size(), 3U);
  EXPECT_EQ(most_at_once(), 1);
}

TEST_F(SideBySide, ThoseThatAreToBeAloneAreAndComeLast) {
  std::vector<std::size_t> order;
  run_side_by_side(
      {child("Lasts", 1, true), child("Lasts", 1, true), child("EndsWithSeven")}, 100,
      [&](std::size_t k, const OwnRunEnd&) { order.push_back(k); }, [] {});
  EXPECT_EQ(order, (std::vector<std::size_t>{2, 0, 1}));
  EXPECT_EQ(most_at_once(), 1);
}

TEST_F(SideBySide, AFaultOfWhoListensEndsThemAll) {
  EXPECT_THROW(run_side_by_side(
                   {child("EndsWithSeven"), child("Lasts"), child("Lasts")}, 100,
                   [](std::size_t, const OwnRunEnd&) { throw std::runtime_error("no more"); }, [] {}),
               std::runtime_error);
}

}  // namespace side_by_side_test
}  // namespace plumb
