#include "engine/study/work_precision/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/parse_json.h"
#include "engine/run/method_json.h"
#include "engine/run/provenance.h"
#include "engine/run/stored_parts.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

std::string run_key(const MethodSpec& method, int elements) {
  std::string key = fmt::format("{} {}", elements, method.name);
  if (method.step) key += fmt::format(" step={}", *method.step);
  if (method.rtol) key += fmt::format(" rtol={} atol={}", *method.rtol, method.atol.value_or(0));
  for (const auto& [name, value] : method.parameters) key += fmt::format(" {}={}", name, value);
  return key;
}

/// What is not finite has no number in JSON.
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json norms_json(const ErrorNorms& norms) {
  return {norms.tip_max, norms.tip_rms, norms.curve, norms.energy};
}

ErrorNorms norms_of(const Json& json) {
  return {number(json.at(0)), number(json.at(1)), number(json.at(2)), number(json.at(3))};
}

Json run_json(const StudyRun& run) {
  Json counters = Json::array();
  for (const auto& [name, part] : stored_counters()) counters.push_back(run.counters.*part);
  return {{"method", method_to_json(run.method)},
          {"elements", run.elements},
          {"outcome", word(run.outcome)},
          {"message", run.message},
          {"counters", counters},
          {"time_error", norms_json(run.time_error)},
          {"total_error", norms_json(run.total_error)}};
}

StudyRun run_of(const Json& json) {
  StudyRun run;
  run.method = method_from_json(json.at("method"));
  run.elements = json.at("elements");
  run.outcome = stored_outcome(json.at("outcome"));
  run.message = json.at("message");
  std::size_t k = 0;
  for (const auto& [name, part] : stored_counters()) run.counters.*part = json.at("counters").at(k++);
  run.time_error = norms_of(json.at("time_error"));
  run.total_error = norms_of(json.at("total_error"));
  return run;
}

Json reference_json(const StudyReference& reference) {
  const CertifiedReference& c = reference.certificate;
  return {{"method", method_to_json(reference.method)},
          {"elements", c.elements},
          {"first", c.first},
          {"second", c.second},
          {"agreement", c.agreement},
          {"completed", !reference.trajectory.times.empty()}};
}

StudyReference reference_of(const Json& json) {
  StudyReference reference;
  // One that gave no trajectory is marked by the lack of a method.
  if (json.at("completed").get<bool>()) reference.method = method_from_json(json.at("method"));
  reference.certificate.elements = json.at("elements");
  reference.certificate.first = json.at("first");
  reference.certificate.second = json.at("second");
  reference.certificate.agreement = number(json.at("agreement"));
  return reference;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

constexpr std::size_t sum_digits = 8;

/// Of a line and of the journal it is in, so that no line counts in another one.
std::string check_sum(std::string_view line, const std::string& identity) {
  const auto add = [](uLong sum, std::string_view bytes) {
    return crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  };
  return fmt::format("{:08x}", add(add(0, identity + '\n'), line));
}

std::string heading(const std::string& identity) {
  return text_of({{"plumb_study_journal", 2}, {"identity", identity}}) + "\n";
}

/// Whether it has the whole heading of a journal, of any version, or was cut off within the heading that is
/// to be written, so that nothing else is in it.
bool is_ours(std::string_view text, std::string_view own_heading) {
  if (own_heading.starts_with(text)) return true;
  constexpr std::string_view begin = R"({"identity":")";
  constexpr std::size_t longest = 4096;
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos || end > longest || !text.starts_with(begin)) return false;
  const Json first = Json::parse(text.substr(0, end), nullptr, false);
  return first.is_object() && first.size() == 2 && first.contains("plumb_study_journal") &&
         first["plumb_study_journal"].is_number_integer() && first["identity"].is_string();
}

}  // namespace

StudyJournal::StudyJournal(std::string path, const std::string& identity)
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

void StudyJournal::go_on() {
  struct stat status {};
  if (::fstat(file_, &status) != 0) fail(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) fail("it is no file");
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) fail("another study is at work on it");
  const std::string text = read(status.st_size);
  const std::string first = heading(identity_);
  if (!is_ours(text, first)) fail("it is there and is no journal of a study");
  const bool same = text.starts_with(first);
  if (status.st_nlink > 1) fail("it is there under two names, so it is left alone");
  std::size_t end_of_whole = first.size();
  for (std::size_t end; same && (end = text.find('\n', end_of_whole)) != std::string::npos;) {
    if (!take(text.substr(end_of_whole, end - end_of_whole))) ++damaged_;
    end_of_whole = end + 1;
  }
  // A line that was cut off goes, so that the next one does not run into it.
  if (::ftruncate(file_, same ? static_cast<off_t>(end_of_whole) : 0) != 0) fail(std::strerror(errno));
  if (!same) write(first);
}

std::string StudyJournal::read(long size) const {
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

void StudyJournal::fail(const std::string& why) const {
  throw WriteError(path_, why);
}

StudyJournal::~StudyJournal() {
  if (file_ >= 0) ::close(file_);
}

bool StudyJournal::take(const std::string& line) {
  if (line.size() <= sum_digits || line[sum_digits] != ' ') return false;
  const std::string text = line.substr(sum_digits + 1);
  if (!line.starts_with(check_sum(text, identity_))) return false;
  try {
    const auto json = parse_json<Json>(text, path_);
    if (json.contains("run")) {
      const StudyRun run = run_of(json.at("run"));
      runs_[run_key(run.method, run.elements)] = run;
    } else if (json.contains("seconds")) {
      seconds_[json.at("of").get<std::string>()] = json.at("seconds").get<std::vector<double>>();
    } else {
      const StudyReference reference = reference_of(json.at("reference"));
      references_[reference.certificate.elements] = reference;
    }
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    return false;
  }
  ++found_;
  return true;
}

void StudyJournal::append(const std::string& json) {
  write(fmt::format("{} {}\n", check_sum(json, identity_), json));
}

void StudyJournal::write(std::string_view rest) {
  if (file_ < 0) return;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::optional<StudyRun> StudyJournal::find_run(const MethodSpec& method, int elements) const {
  const std::lock_guard lock(guard_);
  const auto found = runs_.find(run_key(method, elements));
  return found != runs_.end() ? std::optional(found->second) : std::nullopt;
}

void StudyJournal::add_run(const StudyRun& run) {
  const std::lock_guard lock(guard_);
  append(text_of({{"run", run_json(run)}}));
  runs_[run_key(run.method, run.elements)] = run;
}

std::vector<double> StudyJournal::find_seconds(const StudyRun& run) const {
  const std::lock_guard lock(guard_);
  const auto found = seconds_.find(run_key(run.method, run.elements));
  return found != seconds_.end() ? found->second : std::vector<double>();
}

void StudyJournal::add_seconds(const StudyRun& run) {
  const std::lock_guard lock(guard_);
  const std::string key = run_key(run.method, run.elements);
  append(text_of({{"of", key}, {"seconds", run.seconds}}));
  seconds_[key] = run.seconds;
}

std::optional<StudyReference> StudyJournal::find_reference(int elements) const {
  const std::lock_guard lock(guard_);
  const auto found = references_.find(elements);
  return found != references_.end() ? std::optional(found->second) : std::nullopt;
}

void StudyJournal::add_reference(const StudyReference& reference) {
  const std::lock_guard lock(guard_);
  append(text_of({{"reference", reference_json(reference)}}));
  StudyReference kept = reference;
  kept.trajectory = {};
  references_[reference.certificate.elements] = kept;
}

void StudyJournal::remove() {
  // Another file may have come to be there.
  struct stat own {
  }, there{};
  if (file_ >= 0 && ::fstat(file_, &own) == 0 && ::lstat(path_.c_str(), &there) == 0 &&
      own.st_dev == there.st_dev && own.st_ino == there.st_ino)
    ::unlink(path_.c_str());
}

std::string study_identity(const CaseSource& source, bool quick) {
  std::string text = source.file.text;
  for (const std::string& override_text : source.overrides) text += '\0' + override_text;
  text += quick ? " quick" : " full";
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
