#include "report/program/printed_page.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>
#include <vector>

#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"
#include "report/program/found_program.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::array browsers{"chromium", "chromium-browser", "google-chrome"};
constexpr auto longest_printing = std::chrono::minutes(2);

std::string browser() {
  for (const char* name : browsers)
    if (std::string file = found_program(name); !file.empty()) return file;
  throw OutputError(fmt::format(
      "{}: needs Chromium, and PATH finds none of {}; index.html needs nothing and prints from any "
      "browser",
      pdf_file, fmt::join(browsers, ", ")));
}

/// A folder of the browser's own, with its profile, the page and what it prints.
class WorkFolder {
 public:
  WorkFolder() {
    std::string pattern = (fs::temp_directory_path() / "plumb_print_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw WriteError(pattern, errno);
    path_ = pattern;
    begin_unfinished(path_, remove);
  }
  ~WorkFolder() {
    remove(path_);
    end_unfinished(path_);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  static void remove(const std::string& path) {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  std::string path_;
};

/// Runs a program to its end in a process group of its own, which is ended with it. Its exit status, or -1
/// where it did not end by itself.
int run_to_end(const std::vector<std::string>& words, const std::string& log) {
  std::vector<std::string> own = words;
  std::vector<char*> pointers;
  for (std::string& word : own) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw WriteError(pdf_file, errno);
  if (child == 0) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    const int nothing = ::open("/dev/null", O_RDONLY), said = ::open(log.c_str(), O_WRONLY | O_CREAT, 0600);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(said, STDOUT_FILENO);
    ::dup2(said, STDERR_FILENO);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  ::setpgid(child, child);
  const auto until = std::chrono::steady_clock::now() + longest_printing;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() < until && !is_interrupted()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      continue;
    }
    ::kill(-child, SIGKILL);
    ::waitpid(child, &status, 0);
    stop_if_interrupted();
    return -1;
  }
  // What it started may outlive it.
  ::kill(-child, SIGKILL);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The bytes of the PDF; empty where it was not printed whole.
std::string printed(const std::string& executable, const WorkFolder& work, bool sandbox) {
  std::vector<std::string> words{executable,
                                 "--headless",
                                 "--disable-gpu",
                                 "--no-first-run",
                                 "--no-pdf-header-footer",
                                 "--user-data-dir=" + work.file("profile"),
                                 "--print-to-pdf=" + work.file(pdf_file)};
  if (!sandbox) words.emplace_back("--no-sandbox");
  words.push_back("file://" + work.file("index.html"));
  if (run_to_end(words, work.file("browser.log")) != 0 || !fs::exists(work.file(pdf_file))) return "";
  std::string bytes = read_file_text(work.file(pdf_file)).text;
  const bool whole =
      bytes.starts_with("%PDF-") &&
      bytes.find("%%EOF", bytes.size() - std::min<std::size_t>(bytes.size(), 32)) != bytes.npos;
  return whole ? bytes : "";
}

}  // namespace

void check_pdf(const Options& options) {
  if (options.pdf) browser();
}

void add_pdf(OutputFolder& folder, const Options& options) {
  if (!options.pdf) return;
  const std::string executable = browser();
  const WorkFolder work;
  write_file(work.file("index.html"), folder.read("index.html"));
  // Its sandbox is not to be had for root, and in some containers; the page is ours and loads nothing.
  std::string bytes = ::geteuid() == 0 ? "" : printed(executable, work, true);
  if (bytes.empty()) bytes = printed(executable, work, false);
  if (bytes.empty())
    throw OutputError(
        fmt::format("{}: {} did not print the page; without --pdf there is the rest of the report", pdf_file,
                    executable));
  folder.write(pdf_file, bytes);
}

}  // namespace plumb
