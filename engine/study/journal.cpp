#include "engine/study/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/parse_json.h"
#include "engine/run/provenance.h"

namespace plumb {
namespace {

std::string text_of(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

constexpr std::size_t sum_digits = 8;

/// Of a line and of the journal it is in, so that no line counts in another one.
std::string check_sum(std::string_view line, const std::string& identity) {
  const auto add = [](uLong sum, std::string_view bytes) {
    return crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  };
  return fmt::format("{:08x}", add(add(0, identity + '\n'), line));
}

std::string summed_line(const std::string& key, const std::string& result, const std::string& identity) {
  const std::string line = fmt::format("{{\"point\":{},\"result\":{}}}", text_of(key), result);
  return fmt::format("{} {}\n", check_sum(line, identity), line);
}

std::string heading(const std::string& identity) {
  return text_of({{"plumb_study_journal", 3}, {"identity", identity}}) + "\n";
}

/// Whether it has the whole heading of a journal, of any version, or was cut off within the heading that is
/// to be written, so that nothing else is in it.
bool is_ours(std::string_view text, std::string_view own_heading) {
  if (own_heading.starts_with(text)) return true;
  constexpr std::string_view begin = R"({"identity":")";
  constexpr std::size_t longest = 4096;
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos || end > longest || !text.starts_with(begin)) return false;
  const nlohmann::json first = nlohmann::json::parse(text.substr(0, end), nullptr, false);
  return first.is_object() && first.size() == 2 && first.contains("plumb_study_journal") &&
         first["plumb_study_journal"].is_number_integer() && first["identity"].is_string();
}

}  // namespace

Journal::Journal(std::string path, const std::string& identity)
    : path_(std::move(path)), identity_(identity) {
  // A link is not followed: what it leads to is not ours to write. Nor is a pipe waited for.
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (file_ < 0) fail(errno == ELOOP ? "it is a link, so it is left alone" : std::strerror(errno));
  try {
    go_on();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

void Journal::go_on() {
  struct stat status {};
  if (::fstat(file_, &status) != 0) fail(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) fail("it is no file");
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) fail("another plumb is at work on it");
  const std::string text = read(status.st_size);
  const std::string first = heading(identity_);
  if (!is_ours(text, first)) fail("it is there and is no journal of a study");
  const bool same = text.starts_with(first);
  if (status.st_nlink > 1) fail("it is there under two names, so it is left alone");
  std::size_t end_of_whole = first.size();
  for (std::size_t end; same && (end = text.find('\n', end_of_whole)) != std::string::npos;) {
    ++(take(text.substr(end_of_whole, end - end_of_whole), identity_) ? found_ : damaged_);
    end_of_whole = end + 1;
  }
  // A line that was cut off goes, so that the next one does not run into it.
  if (::ftruncate(file_, same ? static_cast<off_t>(end_of_whole) : 0) != 0) fail(std::strerror(errno));
  if (!same) write(first);
}

std::string Journal::read(long size) const {
  constexpr long longest = 256L * 1024 * 1024;
  if (size > longest) fail("it is longer than 256 MiB");
  std::string text(static_cast<std::size_t>(size), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::pread(file_, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(std::strerror(errno));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return text.substr(0, done);
}

void Journal::fail(const std::string& why) const {
  throw WriteError(path_, why);
}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

bool Journal::take(const std::string& line, const std::string& identity) {
  if (line.size() <= sum_digits || line[sum_digits] != ' ') return false;
  const std::string text = line.substr(sum_digits + 1);
  if (!line.starts_with(check_sum(text, identity))) return false;
  try {
    const auto json = parse_json<nlohmann::json>(text, path_);
    results_[json.at("point").get<std::string>()] = text_of(json.at("result"));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

void Journal::take_over(const std::string& text, const std::string& identity) {
  const std::string first = heading(identity);
  if (!text.starts_with(first)) return;
  const std::lock_guard lock(guard_);
  for (std::size_t from = first.size(), end; (end = text.find('\n', from)) != std::string::npos;
       from = end + 1)
    take(text.substr(from, end - from), identity);
}

void Journal::write(std::string_view rest) {
  if (file_ < 0) return;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::optional<std::string> Journal::find(const std::string& key) const {
  const std::lock_guard lock(guard_);
  const auto found = results_.find(key);
  return found != results_.end() ? std::optional(found->second) : std::nullopt;
}

void Journal::add(const std::string& key, const std::string& result) {
  const std::lock_guard lock(guard_);
  write(summed_line(key, result, identity_));
  results_[key] = result;
}

bool Journal::empty() const {
  const std::lock_guard lock(guard_);
  return results_.empty();
}

std::string Journal::text(const std::string& identity) const {
  const std::lock_guard lock(guard_);
  std::string text = heading(identity);
  for (const auto& [key, result] : results_) text += summed_line(key, result, identity);
  return text;
}

void Journal::remove() {
  // Another file may have come to be there.
  struct stat own {
  }, there{};
  if (file_ >= 0 && ::fstat(file_, &own) == 0 && ::lstat(path_.c_str(), &there) == 0 &&
      own.st_dev == there.st_dev && own.st_ino == there.st_ino)
    ::unlink(path_.c_str());
}

std::string study_identity(const CaseSource& source) {
  std::string text = source.file.text;
  for (const std::string& override_text : source.overrides) text += '\0' + override_text;
  for (const NamedText& reference : source.references) text += '\0' + reference.text;
  for (const NamedText& run : source.given_runs) text += '\0' + run.text;
  for (const auto& [name, value] : provenance_now())
    if (name == "revision" || name == "compiler" || name == "flags" || name == "processor")
      text += '\0' + value;
  // Two programs of one revision may differ where the checkout has changes of its own.
  struct stat program {};
  if (::stat("/proc/self/exe", &program) == 0)
    text += fmt::format(" {} {}", program.st_size, program.st_mtim.tv_sec);
  return fmt::format("{:08x}-{}", crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()),
                     text.size());
}

}  // namespace plumb
