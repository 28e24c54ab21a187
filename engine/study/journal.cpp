#include "engine/study/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/message.h"

namespace plumb {
namespace {

constexpr int journal_version = 4;
constexpr std::size_t sum_digits = 8;

std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Of a line and of the journal it is in, so that no line counts in another one.
std::string check_sum(std::string_view line, const std::string& identity) {
  const auto add = [](uLong sum, std::string_view bytes) {
    return crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  };
  return fmt::format("{:08x}", add(add(0, identity + '\n'), line));
}

std::string summed(const std::string& line, const std::string& identity) {
  return fmt::format("{} {}\n", check_sum(line, identity), line);
}

// A machine's number in a file is its place among those that the file names.
std::string point_line(const std::string& key, std::size_t machine, double seconds,
                       const std::string& result) {
  return fmt::format(R"({{"point":{},"on":{},"took":{:.3g},"result":{}}})", text_of(key), machine, seconds,
                     result);
}

std::string machine_line(const Machine& machine, std::size_t number) {
  return text_of({{"machine", number},
                  {"host", machine.host},
                  {"processor", machine.processor},
                  {"revision", machine.revision}});
}

std::string heading(const StudyIdentity& identity) {
  return text_of({{"identity", identity.of_case},
                  {"case", identity.case_name},
                  {"program", identity.program},
                  {"plumb_study_journal", journal_version}});
}

/// The first line of a file, without its end; of one that is too long for a heading only the begin.
std::string first_line(std::istream& file) {
  constexpr std::size_t longest = 4096;
  std::array<char, longest> line{};
  file.getline(line.data(), line.size());
  return line.data();
}

/// The first line of a journal of any version; null of anything else.
nlohmann::json read_heading(std::string_view line) {
  constexpr std::string_view begin = R"({"identity":")";
  if (!line.starts_with(begin)) return {};
  nlohmann::json first = nlohmann::json::parse(line, nullptr, false);
  const bool ours = first.is_object() && first.contains("plumb_study_journal") &&
                    first["plumb_study_journal"].is_number_integer() && first["identity"].is_string() &&
                    (first.size() == 2 || (first.size() == 4 && first.contains("case") &&
                                           first.contains("program") && first["program"].is_string()));
  return ours ? first : nlohmann::json();
}

/// Cuts what `part` matches off the begin of a text; false if it does not begin so.
bool cut(std::string_view& text, std::string_view part) {
  if (!text.starts_with(part)) return false;
  text.remove_prefix(part.size());
  return true;
}

template <class Number>
bool cut_number(std::string_view& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool cut_string(std::string_view& text, std::string& value) {
  if (text.empty() || text.front() != '"') return false;
  std::size_t end = 1;
  while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
  if (end >= text.size()) return false;
  const std::string_view inner = text.substr(1, end - 1);
  if (inner.find('\\') == inner.npos)
    value = inner;
  else if (const auto json = nlohmann::json::parse(text.substr(0, end + 1), nullptr, false); json.is_string())
    value = json.get<std::string>();
  else
    return false;
  text.remove_prefix(end + 1);
  return true;
}

}  // namespace

/// The lines of a file, as long as they are whole, taken into a journal.
class Journal::Lines {
 public:
  Lines(Journal& journal, const std::string& identity)
      : journal_(journal), identity_(identity), source_(++journal.sources_) {}

  /// Of the rest of a file. A last line without an end was cut off.
  void take_all(std::istream& file) {
    for (std::string line; std::getline(file, line) && !file.eof();) {
      size_ += line.size() + 1;
      if (!take(line)) ++damaged_;
    }
  }

  std::size_t size() const { return size_; }
  std::size_t points() const { return points_; }
  std::size_t damaged() const { return damaged_; }
  const std::map<std::size_t, std::size_t>& machines() const { return machines_; }

 private:
  /// False if the line is damaged. What has its check sum has the form that it was written in.
  bool take(std::string_view line) {
    if (line.size() <= sum_digits || line[sum_digits] != ' ') return false;
    std::string_view text = line.substr(sum_digits + 1);
    if (!line.starts_with(check_sum(text, identity_))) return false;
    if (text.starts_with(R"({"machine")")) return take_machine(text);
    std::string key;
    if (cut(text, R"({"missing":)")) {
      if (!cut_string(text, key)) return false;
      journal_.missing_.insert(std::move(key));
      return true;
    }
    std::size_t machine = 0;
    double seconds = -1;
    if (!cut(text, R"({"point":)") || !cut_string(text, key) || !cut(text, R"(,"on":)") ||
        !cut_number(text, machine) || !cut(text, R"(,"took":)") || !cut_number(text, seconds) ||
        !cut(text, R"(,"result":)") || !text.ends_with('}') || !machines_.contains(machine))
      return false;
    text.remove_suffix(1);
    ++points_;
    Result result{std::string(text), seconds, machines_[machine], source_};
    // What was computed again in one journal counts; of several journals, the first.
    const auto [known, is_new] = journal_.results_.try_emplace(std::move(key), result);
    if (!is_new && known->second.source == source_) known->second = std::move(result);
    return true;
  }

  bool take_machine(std::string_view text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) return false;
    machines_[json.value("machine", std::size_t{0})] =
        journal_.number_of({json.value("host", ""), json.value("processor", ""), json.value("revision", "")});
    return true;
  }

  Journal& journal_;
  const std::string& identity_;
  std::size_t source_;
  std::size_t size_ = 0;
  std::size_t points_ = 0;
  std::size_t damaged_ = 0;
  std::map<std::size_t, std::size_t> machines_;  // number in the file: place in the journal
};

Journal::Journal(std::string path, StudyIdentity identity)
    : path_(std::move(path)), identity_(std::move(identity)) {
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
  locked_ = ::flock(file_, LOCK_EX | LOCK_NB) == 0;
  if (!locked_ && errno == EWOULDBLOCK) fail("another plumb is at work on it");
  std::ifstream file(fmt::format("/proc/self/fd/{}", file_), std::ios::binary);
  if (!file) fail(std::strerror(errno));
  const std::string own = heading(identity_);
  const std::string first = first_line(file);
  // One that was cut off within the heading has nothing else in it.
  const bool cut_off = file.eof() && (own + '\n').starts_with(first);
  if (!cut_off && (!file.good() || read_heading(first).is_null()))
    fail("it is there and is no journal of a study");
  if (status.st_nlink > 1) fail("it is there under two names, so it is left alone");
  const bool same = !cut_off && first == own;
  Lines lines(*this, own);
  if (same) lines.take_all(file);
  found_ = lines.points();
  damaged_ = lines.damaged();
  // A line that was cut off goes, so that the next one does not run into it.
  if (::ftruncate(file_, same ? static_cast<off_t>(own.size() + 1 + lines.size()) : 0) != 0)
    fail(std::strerror(errno));
  if (!same) write(own + '\n');
  for (const auto& [number, machine] : lines.machines())
    if (number == machine) said_.insert(machine);
}

void Journal::fail(const std::string& why) const {
  throw WriteError(path_, why);
}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

void Journal::take_over(const std::string& path, const StudyIdentity& identity) {
  std::ifstream file(path, std::ios::binary);
  const std::string own = heading(identity);
  if (first_line(file) != own || !file.good()) return;
  const std::lock_guard lock(guard_);
  Lines(*this, own).take_all(file);
}

void Journal::merge(const std::string& path, const StudyIdentity& identity) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  const std::string first = first_line(file);
  const nlohmann::json found = read_heading(first);
  if (found.is_null() || !file.good()) throw InputError(path + ": is no journal of a study");
  if (found["plumb_study_journal"] != journal_version)
    throw InputError(fmt::format("{}: is a journal of version {}, this program reads {}", path,
                                 found["plumb_study_journal"].dump(), journal_version));
  if (found["identity"] != identity.of_case)
    throw InputError(
        one_line(fmt::format("{}: is of another case, {} with other texts, references or --set than {}", path,
                             found.value("case", "?"), identity.case_name)));
  if (found["program"] != identity.program)
    throw InputError(one_line(fmt::format("{}: is of another program: {}; this one is {}", path,
                                          found["program"].get<std::string>(), identity.program)));
  const std::string own = heading(identity);
  if (first != own)
    throw InputError(one_line(fmt::format("{}: is of the case file {}, not {}", path,
                                          found.value("case", "?"), identity.case_name)));
  const std::lock_guard lock(guard_);
  Lines lines(*this, own);
  lines.take_all(file);
  damaged_ += lines.damaged();
  found_ += lines.points();
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

std::size_t Journal::number_of(const Machine& machine) {
  const auto known = std::find(machines_.begin(), machines_.end(), machine);
  if (known == machines_.end()) return machines_.push_back(machine), machines_.size() - 1;
  return static_cast<std::size_t>(known - machines_.begin());
}

std::optional<std::string> Journal::find(const std::string& key) const {
  const std::lock_guard lock(guard_);
  const auto found = results_.find(key);
  return found != results_.end() ? std::optional(found->second.text) : std::nullopt;
}

const Machine& Journal::machine_of(const std::string& key) const {
  const std::lock_guard lock(guard_);
  return machines_[results_.at(key).machine];
}

double Journal::seconds_of(const std::string& key) const {
  const std::lock_guard lock(guard_);
  return results_.at(key).seconds;
}

void Journal::add(const std::string& key, const std::string& result, double seconds, const Machine& on) {
  const std::lock_guard lock(guard_);
  const std::size_t machine = number_of(on);
  std::string lines;
  const std::string own = heading(identity_);
  if (said_.insert(machine).second) lines = summed(machine_line(on, machine), own);
  write(lines + summed(point_line(key, machine, seconds, result), own));
  results_[key] = {result, seconds, machine, 0};
}

bool Journal::empty() const {
  return points() == 0;
}

std::size_t Journal::points() const {
  const std::lock_guard lock(guard_);
  return results_.size();
}

std::vector<std::pair<Machine, std::size_t>> Journal::machines() const {
  const std::lock_guard lock(guard_);
  std::vector<std::pair<Machine, std::size_t>> all;
  for (const Machine& machine : machines_) all.emplace_back(machine, 0);
  for (const auto& [key, result] : results_) ++all[result.machine].second;
  return all;
}

std::string Journal::text(const StudyIdentity& identity,
                          const std::function<bool(const std::string&)>& wanted,
                          const std::vector<std::string>& missing) const {
  const std::lock_guard lock(guard_);
  const std::string own = heading(identity);
  std::string text = own + '\n';
  for (std::size_t k = 0; k < machines_.size(); ++k) text += summed(machine_line(machines_[k], k), own);
  for (const auto& [key, result] : results_)
    if (!wanted || wanted(key))
      text += summed(point_line(key, result.machine, result.seconds, result.text), own);
  for (const std::string& key : missing) text += summed(text_of({{"missing", key}}), own);
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

}  // namespace plumb
