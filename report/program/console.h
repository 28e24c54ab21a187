#pragma once

#include <string>

namespace plumb {

/// What the program says to people. With `--json` it goes to standard error, so that standard output is the
/// result alone; with `--quiet` nothing is said but errors. Colour and the progress bar appear on terminals
/// only, colour not where NO_COLOR is set.
class Console {
 public:
  Console(bool to_stderr, bool quiet);

  void line(const std::string& text);
  /// A line about something that the user may not have expected.
  void remark(const std::string& text);
  /// A fault beside which work goes on; said in any case.
  void error(const std::string& text);
  /// Draws or moves the progress bar; `share` in [0, 1].
  void progress(const std::string& what, double share);
  /// Removes the progress bar.
  void end_progress();

  std::string good(const std::string& text) const { return paint("32", text); }
  std::string bad(const std::string& text) const { return paint("31;1", text); }
  std::string faint(const std::string& text) const { return paint("2", text); }

 private:
  std::string paint(const char* code, const std::string& text) const;

  bool to_stderr_;
  bool quiet_;
  bool color_;
  bool bar_;
  int shown_percent_ = -1;
};

}  // namespace plumb
