#pragma once

#include <sys/types.h>

#include <deque>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumb {

using Json = nlohmann::json;

/// Debian's Chromium without a window, spoken to over a pipe in the Chrome DevTools Protocol: messages of
/// JSON, each ended by a zero byte, on its file descriptors 3 and 4. Errors throw std::runtime_error.
class Chromium {
 public:
  /// Starts it with a profile of its own in `folder`; without its sandbox where it does not start with it, as
  /// for root. Throws where it does not start at all.
  Chromium(const std::string& program, const std::string& folder);
  /// One that was left in a folder, without the pages that others left open in it. Throws where there is
  /// none, or where another process uses it.
  explicit Chromium(const std::string& folder);
  ~Chromium();
  Chromium(const Chromium&) = delete;
  Chromium& operator=(const Chromium&) = delete;

  /// Starts one in a folder that must be there, for others to use one after another until the process that
  /// started this one ends. Throws where it does not start.
  static void leave_one(const std::string& program, const std::string& folder);

  /// The result of a method of the protocol, in a session where one is named.
  Json call(const std::string& method, const Json& parameters = Json::object(),
            const std::string& session = "");
  /// The events that came since this was last asked, after those under way have been taken in.
  std::vector<Json> events();
  /// Waits for an event of a session and leaves all events where they are.
  void wait_for(const std::string& event, const std::string& session);

 private:
  /// What it reads and writes, and the other ends.
  struct Ends {
    int there, back, to, from;
  };
  using MakeEnds = Ends (*)(const std::string& folder);

  Chromium() = default;
  void start(const std::string& program, const std::string& folder, MakeEnds make);
  void start(const std::string& program, const std::string& folder, const Ends& ends, bool sandbox);
  void stop();
  Json receive();

  pid_t child_ = -1;
  int to_ = -1;
  int from_ = -1;
  int lock_ = -1;
  int last_id_ = 0;
  std::string buffer_;
  std::deque<Json> events_;
};

/// A tab with one page.
class Tab {
 public:
  explicit Tab(Chromium& chromium);
  ~Tab();
  Tab(const Tab&) = delete;
  Tab& operator=(const Tab&) = delete;

  Json call(const std::string& method, const Json& parameters = Json::object());
  void open(const std::string& url);
  /// Width and height, CSS pixels.
  void resize(int width, int height);
  /// "prefers-color-scheme", "dark"; of all features, those not named are as by default.
  void emulate(const Json& features, const std::string& media = "");
  /// The value of a JavaScript expression; awaits a promise. Throws where it throws.
  Json value_of(const std::string& expression);
  /// Waits until an expression is true; throws after ten minutes.
  void wait_until(const std::string& expression);
  void move_mouse(double x, double y);
  void press(const std::string& key, int code);
  /// What went wrong since this was last asked: requests that leave, errors and warnings on the console,
  /// scripts that threw, and what the page's policy refused.
  std::vector<std::string> complaints();

 private:
  Chromium& chromium_;
  std::string target_;
  std::string session_;
};

}  // namespace plumb
