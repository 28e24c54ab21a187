#include "report/file_difference.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "engine/errors.h"
#include "render/apng.h"
#include "render/png.h"
#include "report/number_difference.h"

namespace plumb {
namespace {

std::string in_words(const ImageDifference& found, const DifferenceTolerance& tolerance) {
  if (found.identical()) return "the same pixels";
  return fmt::format(
      "{} pixels differ, by up to {} levels; {} by more than {}, at most {:.3g} % of a window of {} pixels, "
      "at "
      "({}, {}); {:.3g} % are allowed",
      found.changed, found.greatest, found.beyond, tolerance.channel, 100 * found.density, difference_window,
      found.x, found.y, 100 * tolerance.density);
}

/// The worse of two outcomes of pictures.
Sameness judge(const ImageDifference& found, const DifferenceTolerance& tolerance, bool to_the_byte) {
  if (found.identical()) return Sameness::identical;
  return !to_the_byte && found.within(tolerance) ? Sameness::within : Sameness::different;
}

FileDifference compare_pictures(const std::string& name, const std::string& a, const std::string& b,
                                const DifferenceOptions& options) {
  FileDifference result{name, Sameness::identical, 0, "the same pixels", {}, {}, {}};
  const DifferenceTolerance defaults;
  const DifferenceTolerance tolerance{options.channel.value_or(defaults.channel),
                                      options.density.value_or(defaults.density)};
  const auto drawn_by = text_in_png(a, renderer_keyword, name);
  const bool same_renderer = drawn_by && drawn_by == text_in_png(b, renderer_keyword, name);
  const bool to_the_byte = same_renderer && !options.channel && !options.density;
  const std::vector<std::string> first = split_apng(a, name), second = split_apng(b, name);
  if (first.size() != second.size()) {
    result.sameness = Sameness::different;
    result.in_words = fmt::format("{} and {} frames", first.size(), second.size());
    return result;
  }
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k] == second[k]) continue;
    const Image one = decode_png(first[k], name), other = decode_png(second[k], name);
    const ImageDifference found = difference(one, other, tolerance);
    const Sameness sameness = judge(found, tolerance, to_the_byte);
    if (sameness == Sameness::identical) continue;
    const bool worse = result.sameness == Sameness::identical ||
                       (sameness == Sameness::different && result.sameness == Sameness::within) ||
                       (sameness == result.sameness && found.density > result.number);
    if (!worse) continue;
    result.sameness = sameness;
    result.number = found.density;
    result.in_words = found.same_size ? in_words(found, tolerance)
                                      : fmt::format("{} x {} and {} x {} pixels", one.width, one.height,
                                                    other.width, other.height);
    if (first.size() > 1) result.in_words = fmt::format("frame {}: {}", k, result.in_words);
    if (to_the_byte) result.in_words += "; the same renderer must give the same bytes";
    result.first = first[k];
    result.second = second[k];
    result.marks = found.same_size ? encode_png(difference_image(one, other, tolerance)) : std::string();
  }
  return result;
}

FileDifference compare_numbers(const std::string& name, const std::string& a, const std::string& b,
                               const DifferenceOptions& options) {
  FileDifference result{name, Sameness::identical, 0, "the same numbers", {}, {}, {}};
  const NumberDifference found = number_difference(a, name, b, name);
  if (!found.unlike.empty()) {
    result.sameness = Sameness::different;
    result.number = -1;
    result.in_words = found.unlike;
  } else if (found.greatest > 0) {
    result.sameness = found.greatest <= options.numbers ? Sameness::within : Sameness::different;
    result.number = found.greatest;
    result.in_words = fmt::format("{:.3g} of the largest, {:.3g} is allowed; {}", found.greatest,
                                  options.numbers, found.where);
  }
  return result;
}

/// Verdicts by name, and the outcome, of a results.json.
std::map<std::string, std::string> verdicts_in(const std::string& text, const std::string& name) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) throw InputError(name + ": is no JSON object");
  std::map<std::string, std::string> result;
  const auto text_of = [](const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  if (json.contains("outcome")) result["outcome"] = text_of(json["outcome"]);
  if (json.contains("verdicts") && json["verdicts"].is_array())
    for (const auto& verdict : json["verdicts"])
      if (verdict.is_object() && verdict.contains("name") && verdict.contains("status"))
        result[text_of(verdict["name"])] = text_of(verdict["status"]);
  return result;
}

FileDifference compare_verdicts(const std::string& name, const std::string& a, const std::string& b) {
  FileDifference result{name, Sameness::identical, -1, "the same verdicts", {}, {}, {}};
  const auto first = verdicts_in(a, name), second = verdicts_in(b, name);
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
  if (changes.empty()) return result;
  result.sameness = Sameness::different;
  result.in_words = changes;
  return result;
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

FileDifference compare_files(const std::string& name, const std::string& a, const std::string& b,
                             const DifferenceOptions& options) {
  if (a == b) return {name, Sameness::identical, 0, "the same bytes", {}, {}, {}};
  try {
    if (name.ends_with(".png")) return compare_pictures(name, a, b, options);
    if (name.ends_with(".csv")) return compare_numbers(name, a, b, options);
    if (name.ends_with("results.json")) return compare_verdicts(name, a, b);
  } catch (const InputError& error) {
    return {name, Sameness::unreadable, -1, error.what(), {}, {}, {}};
  }
  return {name, Sameness::not_compared, -1, "times and paths differ from run to run", {}, {}, {}};
}

}  // namespace plumb
