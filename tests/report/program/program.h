#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace plumb {

namespace fs = std::filesystem;

inline std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_text(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/// A folder of its own for a test, removed with it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const fs::path& parent = fs::temp_directory_path()) {
    std::string name = (parent / "plumb-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

/// What a run of the program gave.
struct Ended {
  int status = -1;
  std::string out;
  std::string err;
};

/// A program under way; its output goes to files in `folder`.
inline pid_t start(const std::vector<std::string>& command, const fs::path& folder) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const auto redirect = [&](const char* name, int to) {
    const int file = ::open((folder / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(file, to);
  };
  redirect("stdout", STDOUT_FILENO);
  redirect("stderr", STDERR_FILENO);
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

inline Ended finish(pid_t child, const fs::path& folder) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), read_text(folder / "stdout"),
          read_text(folder / "stderr")};
}

/// Runs any command in `folder`.
inline Ended run_command(const std::vector<std::string>& command, const fs::path& folder) {
  return finish(start(command, folder), folder);
}

/// Runs plumb with these arguments in `folder`.
inline Ended plumb_in(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), PLUMB_PROGRAM);
  return run_command(arguments, folder);
}

inline std::string case_path(const std::string& name) {
  return std::string(PLUMB_SOURCE_DIR) + "/cases/" + name;
}

/// One line, as every error must be.
inline void expect_one_line(const std::string& text) {
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_TRUE(text.starts_with("plumb: ")) << text;
}

}  // namespace plumb
