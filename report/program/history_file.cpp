#include "report/program/history_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include "engine/base/beneath.h"
#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/interrupt.h"

namespace plumb {
namespace {

constexpr off_t longest_read = off_t{64} << 20;

[[noreturn]] void fail_to_read(const std::string& path, int error) {
  throw InputError(fmt::format("{}: cannot be read: {}", path, std::generic_category().message(error)));
}

/// Waits for its turn: who has the lock only reads or writes a line.
void lock(int file, int how, const std::string& path) {
  constexpr std::chrono::seconds patience(20);
  for (const auto until = std::chrono::steady_clock::now() + patience; ::flock(file, how | LOCK_NB) != 0;) {
    stop_if_interrupted();
    if (errno != EWOULDBLOCK && errno != EINTR) throw WriteError(path, errno);
    if (std::chrono::steady_clock::now() > until) throw WriteError(path, "another program keeps it locked");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::string read_part(int file, off_t from, off_t to, const std::string& path) {
  std::string text(static_cast<std::size_t>(to - from), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count =
        ::pread(file, text.data() + done, text.size() - done, from + static_cast<off_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_read(path, errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  text.resize(done);
  return text;
}

/// The length of an open history. Throws InputError for a file that is none.
off_t length_of_history(int file, const std::string& path) {
  struct stat status {};
  if (::fstat(file, &status) != 0) fail_to_read(path, errno);
  const auto refuse = [&](const char* why) {
    throw InputError(
        fmt::format("{}: is no history of Plumb's: {}; name another file with --history", path, why));
  };
  if (!S_ISREG(status.st_mode)) refuse("it is no regular file");
  const auto begin = static_cast<off_t>(begin_of_history.size());
  if (status.st_size > 0 && read_part(file, 0, std::min(begin, status.st_size), path) != begin_of_history)
    refuse("it does not begin as one does");
  return status.st_size;
}

}  // namespace

History read_history(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file && errno == ENOENT) return {};
  if (!file) fail_to_read(path, errno);
  length_of_history(file.get(), path);
  lock(file.get(), LOCK_SH, path);
  const off_t length = length_of_history(file.get(), path), from = std::max<off_t>(0, length - longest_read);
  std::string text = read_part(file.get(), from, length, path);
  if (from > 0) text.erase(0, text.find('\n') + 1);
  History history = history_in(text);
  if (!history.newer.empty()) throw InputError(path + ": " + history.newer);
  return history;
}

namespace {

/// Throws WriteError where no line can be added later: it is known before all the work.
void check_can_be_written(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK));
  if (file) return;
  if (errno != ENOENT) throw WriteError(path, errno);
  struct stat there {};
  if (::lstat(path.c_str(), &there) == 0) throw WriteError(path, "it is a link to nothing");
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) throw WriteError(path, errno);
}

}  // namespace

void check_history(const std::string& path, Console& console) {
  check_can_be_written(path);
  const History history = read_history(path);
  if (history.damaged.empty()) return;
  const bool one = history.damaged.size() == 1;
  console.remark(fmt::format("{}: line{} {} {} damaged: passed over, and left as {}", path, one ? "" : "s",
                             fmt::join(history.damaged, ", "), one ? "is" : "are",
                             one ? "it is" : "they are"));
}

void append_history(const std::string& path, const Document& entry) {
  const Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0666));
  if (!file) throw WriteError(path, errno);
  length_of_history(file.get(), path);
  lock(file.get(), LOCK_EX, path);
  const off_t length = length_of_history(file.get(), path);
  const std::string line = history_line(entry);
  const std::string text =
      "\n" + read_part(file.get(), std::max<off_t>(0, length - longest_read), length, path);
  if (text.find("\n" + line) != std::string::npos) return;
  const bool cut_off = text.size() > 1 && text.back() != '\n';
  int error = write_all(file.get(), cut_off ? "\n" + line : line);
  if (error == 0) error = flush_to_disk(file.get());
  if (error == 0) return;
  if (::ftruncate(file.get(), length) != 0) error = errno;
  throw WriteError(path, error);
}

void add_history(Document& document, const std::string& path) {
  History history = read_history(path);
  const Document now = history_entry(document);
  if (std::find(history.entries.begin(), history.entries.end(), now) == history.entries.end())
    history.entries.push_back(now);
  document[history_key] = {{"file", path}, {"runs", of_same_case(history, now)}};
}

}  // namespace plumb
