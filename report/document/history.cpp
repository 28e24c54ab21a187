#include "report/document/history.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <filesystem>

#include "engine/base/errors.h"
#include "engine/base/parse_json.h"
#include "engine/run/provenance.h"

namespace plumb {
namespace {

constexpr int history_version = 1;

std::string host() {
  utsname names{};
  return ::uname(&names) == 0 ? names.nodename : "";
}

Document entry_of(const std::string& name, const Document& overrides, const Document& provenance) {
  const auto known = [&](const char* key) { return provenance.value(key, ""); };
  return {{"plumb_history", history_version},
          {"made_at", known("made at")},
          {"program", known("program")},
          {"revision", known("revision")},
          {"host", host()},
          {"processor", known("processor")},
          {"case", name},
          {"overrides", overrides}};
}

/// -1 where there is none.
long version_of(const Document& entry) {
  const bool has_one =
      entry.is_object() && entry.contains("plumb_history") && entry["plumb_history"].is_number_integer();
  return has_one ? entry["plumb_history"].get<long>() : -1;
}

/// Throws where a line has not all that is read of one.
void check_entry(const Document& entry) {
  if (entry.at("plumb_history") != history_version) throw InputError("of another version");
  for (const char* key : {"made_at", "program", "revision", "host", "processor", "case", "outcome", "method"})
    entry.at(key).get<std::string>();
  entry.at("overrides").get<std::vector<std::string>>();
  for (const char* key : {"elements", "steps"}) entry.at(key).get<long>();
  entry.at("solve_seconds").get<double>();
  for (const Document& criterion : entry.at("criteria")) {
    for (const char* key : {"name", "kind", "status", "unit"}) criterion.at(key).get<std::string>();
    if (!criterion.at("value").is_null()) criterion.at("value").get<double>();
    criterion.at("limit").get<double>();
  }
}

}  // namespace

Document history_entry(const Document& document) {
  const Document &the_case = document.at("case"), &solve = document.at("solve");
  Document entry = entry_of(std::filesystem::path(the_case.at("file").get<std::string>()).stem().string(),
                            the_case.at("overrides"), document.at("provenance"));
  entry["outcome"] = document.at("outcome");
  for (const char* key : {"method", "elements", "steps", "solve_seconds"}) entry[key] = solve.at(key);
  if (!entry["solve_seconds"].is_number()) entry["solve_seconds"] = -1;
  entry["criteria"] = Document::array();
  for (const Document& verdict : document.at("verdicts")) {
    Document criterion;
    for (const char* key : {"name", "kind", "status", "value", "limit", "unit"})
      criterion[key] = verdict.at(key);
    entry["criteria"].push_back(std::move(criterion));
  }
  return entry;
}

Document entry_without_report(const std::string& name, const std::vector<std::string>& overrides,
                              const std::string& why) {
  Document provenance;
  for (const auto& [key, value] : provenance_now()) provenance[key] = value;
  Document entry = entry_of(name, overrides, provenance);
  entry.update({{"outcome", "not run"},
                {"method", ""},
                {"elements", -1},
                {"steps", -1},
                {"solve_seconds", -1},
                {"criteria", Document::array()},
                {"fault", why}});
  return entry;
}

std::string history_line(const Document& entry) {
  return entry.dump(-1, ' ', false, Document::error_handler_t::replace) + "\n";
}

History history_in(const std::string& text) {
  History history;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.empty()) continue;
    try {
      Document entry = parse_json<Document>(line, "line");
      if (const long version = version_of(entry); version > history_version)
        history.newer =
            fmt::format("line {} is of version {}, this program knows {}", number, version, history_version);
      check_entry(entry);
      history.entries.push_back(std::move(entry));
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception&) {
      history.damaged.push_back(number);
    }
  }
  return history;
}

std::vector<Document> of_same_case(const History& history, const Document& entry) {
  std::vector<Document> same;
  for (const Document& other : history.entries)
    if (other.at("case") == entry.at("case") && other.at("overrides") == entry.at("overrides"))
      same.push_back(other);
  if (same.size() > most_runs_of_history)
    same.erase(same.begin(), same.end() - static_cast<std::ptrdiff_t>(most_runs_of_history));
  return same;
}

}  // namespace plumb
