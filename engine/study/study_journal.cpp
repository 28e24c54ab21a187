#include "engine/study/study_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "engine/output/beneath.h"
#include "engine/output/file_writing.h"
#include "engine/output/provenance.h"
#include "engine/output/stored_parts.h"
#include "engine/study/method_json.h"

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

Json norms_json(const ErrorNorms& norms) {
  return {norms.tip_max, norms.tip_rms, norms.curve, norms.energy};
}

ErrorNorms norms_of(const Json& json) {
  return {json.at(0), json.at(1), json.at(2), json.at(3)};
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
  reference.certificate.agreement = json.at("agreement");
  return reference;
}

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json heading(const std::string& identity) {
  return {{"plumb_study_journal", 1}, {"identity", identity}};
}

/// Opens the file of a journal, old or new. Whatever is not one of ours is left alone: a link, a file that
/// has another name as well, a pipe, a file that begins like no journal.
int open_journal(const std::string& path) {
  Descriptor file(
      ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_APPEND, 0666));
  if (!file && errno == ELOOP) throw WriteError(path, "it is a link, so it is left alone");
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) throw WriteError(path, errno);
  if (!S_ISREG(status.st_mode) || status.st_nlink != 1)
    throw WriteError(path, "it is no file of its own, so it is left alone");
  if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw WriteError(path, "another study is at work on it");
  return file.release();
}

/// What a journal holds; the file is closed where it is none.
std::string text_of(int& file, const std::string& path) {
  std::string text;
  char part[65536];
  for (ssize_t count; (count = ::read(file, part, sizeof part)) != 0;) {
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int error = errno;
      ::close(std::exchange(file, -1));
      throw WriteError(path, error);
    }
    text.append(part, static_cast<std::size_t>(count));
  }
  constexpr std::string_view beginning = "{\"identity\":";
  if (!text.starts_with(std::string_view(beginning).substr(0, text.size()))) {
    ::close(std::exchange(file, -1));
    throw WriteError(path, "it is no journal of a study, so it is left alone");
  }
  return text;
}

}  // namespace

StudyJournal::StudyJournal(std::string path, const std::string& identity) : path_(std::move(path)) {
  file_ = open_journal(path_);
  const std::string text = text_of(file_, path_);
  const std::string first = line_of(heading(identity));
  const bool same = text.starts_with(first);
  std::size_t end_of_whole = first.size();
  if (same) {
    for (std::size_t from = first.size();;) {
      const std::size_t end = text.find('\n', from);
      if (end == std::string::npos) break;
      take(text.substr(from, end - from));
      from = end_of_whole = end + 1;
    }
  }
  // A line that was cut off goes, so that the next one does not run into it.
  const off_t keep = same ? static_cast<off_t>(end_of_whole) : 0;
  if (::ftruncate(file_, keep) != 0) throw WriteError(path_, errno);
  if (!same) append(first);
}

StudyJournal::~StudyJournal() {
  if (file_ >= 0) ::close(file_);
}

void StudyJournal::take(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    if (json.contains("run")) {
      const StudyRun run = run_of(json.at("run"));
      runs_[run_key(run.method, run.elements)] = run;
    } else if (json.contains("seconds")) {
      seconds_[json.at("of").get<std::string>()] = json.at("seconds").get<std::vector<double>>();
    } else if (json.contains("reference")) {
      const StudyReference reference = reference_of(json.at("reference"));
      references_[reference.certificate.elements] = reference;
    } else {
      return;
    }
    ++found_;
  } catch (const std::exception&) {
    // Damaged: what it held is done again.
  }
}

void StudyJournal::append(const std::string& line) {
  if (file_ < 0) return;
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw WriteError(path_, errno);
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
  append(line_of({{"run", run_json(run)}}));
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
  append(line_of({{"of", key}, {"seconds", run.seconds}}));
  seconds_[key] = run.seconds;
}

std::optional<StudyReference> StudyJournal::find_reference(int elements) const {
  const std::lock_guard lock(guard_);
  const auto found = references_.find(elements);
  return found != references_.end() ? std::optional(found->second) : std::nullopt;
}

void StudyJournal::add_reference(const StudyReference& reference) {
  const std::lock_guard lock(guard_);
  append(line_of({{"reference", reference_json(reference)}}));
  StudyReference kept = reference;
  kept.trajectory = {};
  references_[reference.certificate.elements] = kept;
}

void StudyJournal::remove() {
  if (!path_.empty()) ::unlink(path_.c_str());
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
