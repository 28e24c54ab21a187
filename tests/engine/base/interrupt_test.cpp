#include "engine/base/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/base/errors.h"

namespace plumb {
namespace interrupt_test {

namespace fs = std::filesystem;

/// Work that never looks whether it is to stop.
[[noreturn]] void work_on() {
  for (;;) ::pause();
}

void remove_whole(const std::string& path) {
  fs::remove_all(path);
}

std::string new_folder() {
  std::string folder = (fs::temp_directory_path() / "plumb-test-XXXXXX").string();
  EXPECT_NE(::mkdtemp(folder.data()), nullptr);
  std::ofstream(folder + "/half") << "half";
  return folder;
}

TEST(InterruptDeathTest, WorkThatDoesNotStopIsEndedAndWhatIsUnfinishedRemoved) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string half = new_folder(), whole = new_folder();
    EXPECT_EXIT(
        {
          catch_interrupts();
          begin_unfinished(half, remove_whole);
          begin_unfinished(whole, remove_whole);
          end_unfinished(whole);
          std::raise(signal);
          work_on();
        },
        ::testing::ExitedWithCode(130), "^plumb: interrupted\n$");
    EXPECT_FALSE(fs::exists(half)) << half;
    EXPECT_TRUE(fs::exists(whole + "/half")) << whole;
    fs::remove_all(whole);
  }
}

TEST(InterruptDeathTest, ASecondSignalKills) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        std::raise(SIGTERM);
        std::raise(SIGTERM);
      },
      ::testing::KilledBySignal(SIGTERM), "");
}

TEST(InterruptDeathTest, NothingIsEndedBetweenOldAndNew) {
  const std::string half = new_folder();
  EXPECT_EXIT(
      {
        catch_interrupts();
        begin_unfinished(half, remove_whole);
        {
          const Undivided undivided;
          std::raise(SIGINT);
          ::sleep(1);
          fs::rename(half, half + ".whole");
          end_unfinished(half);
        }
        work_on();
      },
      ::testing::ExitedWithCode(130), "interrupted");
  EXPECT_TRUE(fs::exists(half + ".whole/half"));
  fs::remove_all(half + ".whole");
}

TEST(InterruptDeathTest, WorkThatLooksStopsByItself) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        stop_if_interrupted();
        std::raise(SIGINT);
        try {
          stop_if_interrupted();
        } catch (const Interrupted&) {
          std::_Exit(is_interrupted() ? 7 : 8);
        }
      },
      ::testing::ExitedWithCode(7), "");
}

}  // namespace interrupt_test
}  // namespace plumb
