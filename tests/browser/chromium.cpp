#include "tests/browser/chromium.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace plumb {
namespace {

// The last resort on a machine that is busy, for one answer.
constexpr std::chrono::minutes patience(10);

void close_if_open(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

int open_file(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
  if (file < 0) throw std::runtime_error(path + " cannot be opened");
  return file;
}

// Named pipes of a folder, by which one process after another speaks to what was left there.
std::string to_in(const std::string& folder) {
  return folder + "/to";
}
std::string from_in(const std::string& folder) {
  return folder + "/from";
}

int process_file(pid_t process) {
  return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
}

}  // namespace

Chromium::Chromium(const std::string& program, const std::string& folder) {
  start(program, folder, [](const std::string&) {
    int there[2], back[2];
    if (::pipe2(there, O_CLOEXEC) != 0 || ::pipe2(back, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return Ends{there[0], back[1], there[1], back[0]};
  });
}

Chromium::Chromium(const std::string& folder) {
  ::signal(SIGPIPE, SIG_IGN);
  try {
    lock_ = open_file(folder + "/lock", O_RDWR | O_CREAT);
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) throw std::runtime_error("another process uses it");
    // Not to be had where nobody reads.
    to_ = open_file(to_in(folder), O_WRONLY | O_NONBLOCK);
    ::fcntl(to_, F_SETFL, O_WRONLY);
    from_ = open_file(from_in(folder), O_RDONLY | O_NONBLOCK);
    // Ends what one that was killed may have begun to say; no answer to it has a number of ours.
    if (::write(to_, "", 1) != 1) throw std::runtime_error("Chromium has ended");
    constexpr int processes = 100'000, calls = 10'000;
    last_id_ = ::getpid() % processes * calls;
    events();
    for (const Json& target : call("Target.getTargets")["targetInfos"])
      if (target["type"] == "page" && target["url"] != "about:blank")
        call("Target.closeTarget", {{"targetId", target["targetId"]}});
  } catch (...) {
    stop();
    throw;
  }
}

void Chromium::leave_one(const std::string& program, const std::string& folder) {
  for (const std::string& path : {to_in(folder), from_in(folder)})
    if (::mkfifo(path.c_str(), 0600) != 0) throw std::runtime_error(path + " cannot be made");
  Chromium left;
  left.start(program, folder, [](const std::string& of) {
    // To read and to write, so that none ever comes to an end.
    const auto both = [](const std::string& path) { return open_file(path, O_RDWR); };
    return Ends{both(to_in(of)), both(from_in(of)), both(to_in(of)), both(from_in(of))};
  });
  pollfd ends[] = {{process_file(::getppid()), POLLIN, 0}, {process_file(left.child_), POLLIN, 0}};
  const pid_t keeper = ends[0].fd < 0 || ends[1].fd < 0 ? -1 : ::fork();
  if (keeper < 0) throw std::runtime_error("nobody can end it");
  if (keeper == 0) {
    ::setsid();
    for (int file = 0; file < 3; ++file) ::dup2(left.to_, file);  // the pipes of those who wait for us
    ::poll(ends, 2, -1);
    left.stop();
    ::_exit(0);
  }
  left.child_ = -1;
}

void Chromium::start(const std::string& program, const std::string& folder, MakeEnds make) {
  ::signal(SIGPIPE, SIG_IGN);
  if (::geteuid() != 0) {
    try {
      start(program, folder, make(folder), true);
      return;
    } catch (const std::runtime_error&) {
      stop();  // where user namespaces are not to be had
    }
  }
  try {
    start(program, folder, make(folder), false);
  } catch (...) {
    stop();
    throw;
  }
}

Chromium::~Chromium() {
  stop();
}

void Chromium::start(const std::string& program, const std::string& folder, const Ends& ends, bool sandbox) {
  child_ = ::fork();
  if (child_ == 0) {
    ::setpgid(0, 0);
    // Out of the way first: what is copied must not lie where it goes.
    const int in = ::fcntl(ends.there, F_DUPFD, 10), out = ::fcntl(ends.back, F_DUPFD, 10);
    ::dup2(in, 3);
    ::dup2(out, 4);
    ::close(in);
    ::close(out);
    const int log = ::open((folder + "/chromium.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    const std::string profile = "--user-data-dir=" + folder + "/profile";
    std::vector<const char*> arguments{program.c_str(),           "--headless",
                                       "--remote-debugging-pipe", "--no-first-run",
                                       "--disable-gpu",           "--disable-dev-shm-usage",
                                       "--disable-extensions",    "--disable-background-networking",
                                       "--hide-scrollbars",       profile.c_str()};
    if (!sandbox) arguments.push_back("--no-sandbox");
    arguments.push_back(nullptr);
    ::execv(program.c_str(), const_cast<char* const*>(arguments.data()));
    ::_exit(127);
  }
  ::setpgid(child_, child_);
  ::close(ends.there);
  ::close(ends.back);
  to_ = ends.to;
  from_ = ends.from;
  call("Browser.getVersion");
}

void Chromium::stop() {
  close_if_open(to_);
  close_if_open(from_);
  close_if_open(lock_);
  if (child_ <= 0) return;
  ::kill(-child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
  child_ = -1;
  buffer_.clear();
  events_.clear();
}

Json Chromium::receive() {
  std::size_t end = buffer_.find('\0');
  while (end == buffer_.npos) {
    pollfd waiting{from_, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(std::chrono::milliseconds(patience).count())) <= 0)
      throw std::runtime_error("Chromium does not answer");
    char part[1 << 16];
    const ssize_t read = ::read(from_, part, sizeof part);
    if (read <= 0) throw std::runtime_error("Chromium has ended");
    const std::size_t before = buffer_.size();
    buffer_.append(part, static_cast<std::size_t>(read));
    end = buffer_.find('\0', before);
  }
  Json message = Json::parse(buffer_.substr(0, end));
  buffer_.erase(0, end + 1);
  return message;
}

Json Chromium::call(const std::string& method, const Json& parameters, const std::string& session) {
  const int id = ++last_id_;
  Json message{{"id", id}, {"method", method}, {"params", parameters}};
  if (!session.empty()) message["sessionId"] = session;
  const std::string text = message.dump() + '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = ::write(to_, text.data() + sent, text.size() - sent);
    if (n <= 0) throw std::runtime_error("Chromium has ended");
    sent += static_cast<std::size_t>(n);
  }
  for (;;) {
    Json answer = receive();
    if (!answer.contains("id"))
      events_.push_back(std::move(answer));
    else if (answer["id"] == id) {
      if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
      return answer["result"];
    }
  }
}

std::vector<Json> Chromium::events() {
  call("Browser.getVersion");
  std::vector<Json> result(events_.begin(), events_.end());
  events_.clear();
  return result;
}

void Chromium::wait_for(const std::string& event, const std::string& session) {
  const auto is_it = [&](const Json& e) {
    return e["method"] == event && e.value("sessionId", "") == session;
  };
  for (const Json& e : events_)
    if (is_it(e)) return;
  for (;;) {
    events_.push_back(receive());
    if (is_it(events_.back())) return;
  }
}

Tab::Tab(Chromium& chromium) : chromium_(chromium) {
  target_ = chromium.call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
  session_ = chromium.call("Target.attachToTarget", {{"targetId", target_}, {"flatten", true}})["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(domain + std::string(".enable"));
}

Tab::~Tab() {
  try {
    chromium_.call("Target.closeTarget", {{"targetId", target_}});
  } catch (const std::exception&) {
    // It has ended by itself.
  }
}

Json Tab::call(const std::string& method, const Json& parameters) {
  return chromium_.call(method, parameters, session_);
}

void Tab::open(const std::string& url) {
  chromium_.events();
  call("Page.navigate", {{"url", url}});
  chromium_.wait_for("Page.loadEventFired", session_);
}

void Tab::resize(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Tab::emulate(const Json& features, const std::string& media) {
  Json list = Json::array();
  for (const auto& [name, value] : features.items()) list.push_back({{"name", name}, {"value", value}});
  call("Emulation.setEmulatedMedia", {{"media", media}, {"features", list}});
}

Json Tab::value_of(const std::string& expression) {
  const Json answer = call(
      "Runtime.evaluate",
      {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}, {"userGesture", true}});
  if (answer.contains("exceptionDetails"))
    throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
  return answer["result"].value("value", Json());
}

void Tab::wait_until(const std::string& expression) {
  const auto start = std::chrono::steady_clock::now();
  while (value_of(expression) != true) {
    if (std::chrono::steady_clock::now() - start > patience)
      throw std::runtime_error("not within ten minutes: " + expression);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

void Tab::move_mouse(double x, double y) {
  call("Input.dispatchMouseEvent", {{"type", "mouseMoved"}, {"x", x}, {"y", y}});
}

void Tab::press(const std::string& key, int code) {
  for (const char* type : {"rawKeyDown", "keyUp"})
    call("Input.dispatchKeyEvent",
         {{"type", type}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}});
}

std::vector<std::string> Tab::complaints() {
  std::vector<std::string> found;
  for (const Json& event : chromium_.events()) {
    if (event.value("sessionId", "") != session_) continue;
    const std::string method = event["method"];
    const Json& p = event["params"];
    if (method == "Runtime.exceptionThrown") found.push_back("threw: " + p["exceptionDetails"].dump());
    if (method == "Runtime.consoleAPICalled" && (p["type"] == "error" || p["type"] == "warning"))
      found.push_back("console: " + p["args"].dump());
    if (method == "Log.entryAdded" && (p["entry"]["level"] == "error" || p["entry"]["level"] == "warning"))
      found.push_back("log: " + p["entry"]["text"].get<std::string>());
    if (method == "Network.requestWillBeSent") {
      const std::string url = p["request"]["url"];
      if (!url.starts_with("file:") && !url.starts_with("data:") && !url.starts_with("blob:"))
        found.push_back("request: " + url.substr(0, 200));
    }
  }
  return found;
}

}  // namespace plumb
