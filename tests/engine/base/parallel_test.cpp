#include "engine/base/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace plumb {
namespace parallel_test {

TEST(Parallel, DoesEveryPieceOfWorkOnce) {
  std::vector<std::atomic<int>> done(100);
  for_each_in_parallel(done.size(), [&](std::size_t k) { ++done[k]; });
  for (std::size_t k = 0; k < done.size(); ++k) EXPECT_EQ(done[k], 1) << k;
}

TEST(Parallel, ThrowsWhatAPieceOfWorkThrows) {
  EXPECT_THROW(for_each_in_parallel(50,
                                    [](std::size_t k) {
                                      if (k == 20) throw std::runtime_error("twenty");
                                    }),
               std::runtime_error);
}

[[noreturn]] void work_without_threads() {
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  // Less than the stack of a thread is left.
  const rlim_t left = static_cast<rlim_t>(pages * ::sysconf(_SC_PAGESIZE)) + (1 << 20);
  const rlimit limit{left, left};
  ::setrlimit(RLIMIT_AS, &limit);
  int done = 0;
  for_each_in_parallel(100, [&](std::size_t) { ++done; });
  std::_Exit(done == 100 ? 0 : 1);
}

TEST(ParallelDeathTest, DoesItAllWhereNoThreadIsToBeHad) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer needs the address space that is taken away here";
#endif
  EXPECT_EXIT(work_without_threads(), ::testing::ExitedWithCode(0), "");
}

}  // namespace parallel_test
}  // namespace plumb
