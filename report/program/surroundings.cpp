#include "report/program/surroundings.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "engine/base/errors.h"

namespace plumb {

void open_standard_files() {
  // The lowest that is free is taken, so that each gets its own number. Each is open for what it is not for.
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(file, F_GETFD) < 0 && ::open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0)
      ::open("/", O_RDONLY | O_DIRECTORY);
}

void refuse_short_stack() {
  constexpr rlim_t least = 1 << 20, kibibyte = 1024;
  rlimit limit{};
  if (::getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < least)
    throw OutputError(fmt::format("the stack may be no more than {} kB (ulimit -s), and {} kB are needed",
                                  limit.rlim_cur / kibibyte, least / kibibyte));
}

}  // namespace plumb
