#include "report/program/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "engine/base/message.h"

namespace plumb {

Console::Console(bool to_stderr, bool quiet)
    : to_stderr_(to_stderr),
      quiet_(quiet),
      color_(isatty(to_stderr ? STDERR_FILENO : STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr),
      bar_(!quiet && isatty(STDERR_FILENO) == 1) {}

std::string Console::paint(const char* code, const std::string& text) const {
  return color_ ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

void Console::line(const std::string& text) {
  if (quiet_) return;
  end_progress();
  std::FILE* out = to_stderr_ ? stderr : stdout;
  std::fputs((text + "\n").c_str(), out);
  std::fflush(out);
}

void Console::remark(const std::string& text) {
  if (quiet_) return;
  end_progress();
  std::fputs(("plumb: note: " + one_line(text) + "\n").c_str(), stderr);
}

void Console::error(const std::string& text) {
  end_progress();
  std::fputs(("plumb: " + one_line(text) + "\n").c_str(), stderr);
}

void Console::progress(const std::string& what, double share) {
  const int percent = static_cast<int>(100 * share);
  if (!bar_ || percent == shown_percent_) return;
  shown_percent_ = percent;
  constexpr int width = 30;
  const int filled = percent * width / 100;
  std::fputs(
      fmt::format("\r{:<10} [{:=<{}}{: <{}}] {:3} %", what, "", filled, "", width - filled, percent).c_str(),
      stderr);
}

void Console::end_progress() {
  if (!bar_ || shown_percent_ < 0) return;
  shown_percent_ = -1;
  std::fputs("\r\x1b[K", stderr);
}

}  // namespace plumb
