#include "report/diff/file_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/parse_json.h"
#include "report/diff/number_difference.h"
#include "report/diff/picture_difference.h"
#include "report/document/report_formats.h"

namespace plumb {
namespace {

FileDifference nothing_in(const std::string& what) {
  return {{}, Sameness::not_compared, -1, what, {}, {}, {}};
}

FileDifference compare_numbers(const std::string& a, const std::string& name_a, const std::string& b,
                               const std::string& name_b, const DifferenceOptions& options) {
  const NumberDifference found = number_difference(a, name_a, b, name_b);
  if (!found.unlike.empty()) return {{}, Sameness::different, -1, found.unlike, {}, {}, {}};
  if (found.numbers == 0) return nothing_in("there are no numbers in them");
  if (found.differing == 0) return {{}, Sameness::identical, 0, "the same numbers", {}, {}, {}};
  const bool within = std::isfinite(found.greatest) && found.greatest <= options.numbers;
  return {{},
          within ? Sameness::within : Sameness::different,
          found.greatest,
          fmt::format("{:.3g} of the largest, {:.3g} is allowed; {}", found.greatest, options.numbers,
                      found.where),
          {},
          {},
          {}};
}

/// The outcome, and the status, kind and criterion of each verdict, by name, of a results.json and of the
/// reports it lists.
using Statuses = std::map<std::string, std::string>;

void add_statuses(const nlohmann::json& json, const std::string& prefix, Statuses& all) {
  const auto text_of = [](const nlohmann::json& object, const char* key) -> std::string {
    const auto found = object.find(key);
    if (found == object.end()) return "none";
    return found->is_string() ? found->get<std::string>() : found->is_boolean() ? found->dump() : "no text";
  };
  const auto add = [&](const std::string& name, const std::string& status) {
    std::string key = name;
    // Verdicts of one name are told apart by their order.
    for (int number = 2; !all.emplace(key, status).second; ++number)
      key = fmt::format("{} ({})", name, number);
  };
  for (const char* key : {"outcome", "all_criteria_met"})
    if (json.contains(key)) add(prefix + key, text_of(json, key));
  if (const auto verdicts = json.find("verdicts"); verdicts != json.end() && verdicts->is_array())
    for (const auto& verdict : *verdicts)
      if (verdict.is_object()) {
        const std::string name = prefix + text_of(verdict, "name");
        add(name, text_of(verdict, "status"));
        for (const char* key : {"kind", "criterion"})
          if (verdict.contains(key)) add(fmt::format("{}, {}", name, key), text_of(verdict, key));
      }
  if (const auto reports = json.find("reports"); reports != json.end() && reports->is_array())
    for (const auto& report : *reports)
      if (report.is_object()) add_statuses(report, prefix + text_of(report, "folder") + ": ", all);
}

Statuses statuses_in(const std::string& text, const std::string& name) {
  const auto json = parse_json<nlohmann::json>(text, name);
  if (!json.is_object()) throw InputError(name + ": is no JSON object");
  Statuses all;
  add_statuses(json, "", all);
  return all;
}

FileDifference compare_verdicts(const std::string& a, const std::string& name_a, const std::string& b,
                                const std::string& name_b) {
  const Statuses first = statuses_in(a, name_a), second = statuses_in(b, name_b);
  if (first.empty() && second.empty()) return nothing_in("there are no verdicts in them");
  std::string changes;
  const auto add = [&](const std::string& what, const std::string& before, const std::string& now) {
    changes += fmt::format("{}{}: {} → {}", changes.empty() ? "" : "; ", what, before, now);
  };
  for (const auto& [what, before] : first)
    if (const auto now = second.find(what); now == second.end())
      add(what, before, "not there");
    else if (now->second != before)
      add(what, before, now->second);
  for (const auto& [what, now] : second)
    if (!first.contains(what)) add(what, "not there", now);
  if (changes.empty()) return {{}, Sameness::identical, -1, "the same verdicts", {}, {}, {}};
  return {{}, Sameness::different, -1, changes, {}, {}, {}};
}

FileDifference compare_contents(Comparing how, const std::string& a, const std::string& name_a,
                                const std::string& b, const std::string& name_b,
                                const DifferenceOptions& options) {
  switch (how) {
    case Comparing::pictures:
      return compare_pictures(a, name_a, b, name_b, options);
    case Comparing::numbers:
      return compare_numbers(a, name_a, b, name_b, options);
    case Comparing::verdicts:
      return compare_verdicts(a, name_a, b, name_b);
    case Comparing::bytes:
    case Comparing::nothing:
      break;
  }
  return {};
}

}  // namespace

std::string word(Sameness sameness) {
  switch (sameness) {
    case Sameness::identical:
      return "identical";
    case Sameness::within:
      return "within tolerance";
    case Sameness::different:
      return "different";
    case Sameness::only_first:
      return "missing";
    case Sameness::only_second:
      return "new";
    case Sameness::unreadable:
      return "unreadable";
    case Sameness::not_compared:
      return "not compared";
  }
  return "not compared";
}

bool fails(Sameness sameness) {
  return sameness != Sameness::identical && sameness != Sameness::within &&
         sameness != Sameness::not_compared;
}

bool differs(const std::vector<FileDifference>& files) {
  return std::any_of(files.begin(), files.end(),
                     [](const FileDifference& file) { return fails(file.sameness); });
}

long compared(const std::vector<FileDifference>& files) {
  return std::count_if(files.begin(), files.end(),
                       [](const FileDifference& file) { return file.sameness != Sameness::not_compared; });
}

Comparing comparing(const std::string& name) {
  // They hold times, paths, or what follows from those.
  constexpr std::array unlike{"run.h5",      "study.h5",        "study.json",
                              "choice.json", "assessment.json", "sensitivity.json",
                              "index.html",  "report.pdf",      "manifest.json"};
  const std::string file = name.substr(name.rfind('/') + 1);
  if (file.ends_with(".png")) return Comparing::pictures;
  if (file.ends_with(".csv")) return Comparing::numbers;
  if (file == "results.json") return Comparing::verdicts;
  const std::span<const std::string_view> formats = report_files();
  const bool differs = std::find(unlike.begin(), unlike.end(), file) != unlike.end() ||
                       std::find(formats.begin(), formats.end(), file) != formats.end();
  return differs ? Comparing::nothing : Comparing::bytes;
}

FileDifference by_bytes(const std::string& name, bool same) {
  if (same) return {name, Sameness::identical, 0, "the same bytes", {}, {}, {}};
  if (comparing(name) == Comparing::nothing)
    return {name, Sameness::not_compared, -1, "times and paths differ from run to run", {}, {}, {}};
  return {name, Sameness::different, -1, "other bytes", {}, {}, {}};
}

FileDifference compare_files(const std::string& name, const std::string& a, const std::string& name_a,
                             const std::string& b, const std::string& name_b,
                             const DifferenceOptions& options) {
  const Comparing how = comparing(name);
  if (how == Comparing::bytes || how == Comparing::nothing) return by_bytes(name, a == b);
  FileDifference result;
  try {
    result = compare_contents(how, a, name_a, b, name_b, options);
  } catch (const InputError& error) {
    result = {{}, Sameness::unreadable, -1, error.what(), {}, {}, {}};
  }
  if (a == b && result.sameness == Sameness::identical) result.in_words = "the same bytes";
  result.name = name;
  return result;
}

FileDifference compare_files(const std::string& name, const std::string& a, const std::string& b,
                             const DifferenceOptions& options) {
  return compare_files(name, a, name, b, name, options);
}

}  // namespace plumb
