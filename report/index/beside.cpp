#include "report/index/beside.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "engine/base/time_interpolation.h"
#include "report/document/changes.h"
#include "report/figure/number_markup.h"
#include "report/index/study_as_report.h"
#include "report/page/page_template.h"
#include "report/page/verdict_html.h"

namespace plumb {

extern const std::string_view beside_mustache;

namespace {

using kainjow::mustache::data;

const Document* named(const Document& list, const std::string& name) {
  for (const Document& one : list)
    if (one.at("name") == name) return &one;
  return nullptr;
}

/// second − first, where both are finite; else null.
Document difference(const Document& first, const Document& second) {
  const double value = number_of(second) - number_of(first);
  return std::isfinite(value) ? Document(value) : Document(nullptr);
}

void cannot(Document& beside, const std::string& what, const std::string& why) {
  beside["not_compared"].push_back({{"what", what}, {"why", why}});
}

std::string only_in(const Document& beside, bool is_first) {
  return fmt::format("only {} has it", text_of(beside, is_first ? "first" : "second"));
}

void add_verdicts(Document& beside, const Document& first, const Document& second) {
  beside["verdicts"] = Document::array();
  const auto side = [](const Document& verdict) {
    return Document{
        {"status", verdict.at("status")}, {"value", verdict.at("value")}, {"limit", verdict.at("limit")}};
  };
  for (const Document& verdict : first.at("verdicts")) {
    const std::string name = text_of(verdict, "name");
    const Document* other = named(second.at("verdicts"), name);
    if (other == nullptr) {
      cannot(beside, "verdict " + name, only_in(beside, true));
      continue;
    }
    if (verdict.at("unit") != other->at("unit") || verdict.at("kind") != other->at("kind")) {
      cannot(beside, "verdict " + name,
             fmt::format("{} in {} and {} in {}", text_of(verdict, "kind"), text_of(verdict, "unit"),
                         text_of(*other, "kind"), text_of(*other, "unit")));
      continue;
    }
    const bool both = verdict.at("status") != "not run" && other->at("status") != "not run";
    beside["verdicts"].push_back(
        {{"name", name},
         {"kind", verdict.at("kind")},
         {"unit", verdict.at("unit")},
         {"first", side(verdict)},
         {"second", side(*other)},
         {"difference", both ? difference(verdict.at("value"), other->at("value")) : Document(nullptr)}});
  }
  for (const Document& verdict : second.at("verdicts"))
    if (named(first.at("verdicts"), text_of(verdict, "name")) == nullptr)
      cannot(beside, "verdict " + text_of(verdict, "name"), only_in(beside, false));
}

void add_numbers(Document& beside, const Document& first, const Document& second) {
  beside["numbers"] = Document::array();
  const auto add = [&](const std::string& name, const std::string& unit, const Document& one,
                       const Document& other) {
    // What was not counted or timed is -1.
    const auto known = [](const Document& value) { return value.is_number() && value.get<double>() >= 0; };
    if (!known(one) && !known(other)) return;
    if (known(one) && known(other))
      beside["numbers"].push_back({{"name", name},
                                   {"unit", unit},
                                   {"first", one},
                                   {"second", other},
                                   {"difference", difference(one, other)}});
    else
      cannot(beside, name, only_in(beside, known(one)));
  };
  const Document &one = first.at("solve"), &other = second.at("solve"), none;
  for (const auto& [key, name, unit] : {std::tuple{"elements", "elements", "1"},
                                        {"end_time", "end of the run", "s"},
                                        {"solve_seconds", "time loop, by the clock", "s"},
                                        {"steps", "steps", "1"},
                                        {"rejected_steps", "rejected steps", "1"},
                                        {"force_evaluations", "evaluations of the force", "1"},
                                        {"tangent_evaluations", "evaluations of the tangent", "1"},
                                        {"newton_iterations", "Newton iterations", "1"}})
    add(name, unit, one.value(key, none), other.value(key, none));
  const auto drift = [&](const Document& document) {
    return document.at("energy").is_null() ? none : document.at("energy").at("drift");
  };
  add("drift of the energy", "J", drift(first), drift(second));
}

/// All numbers of an object and of those within it, by their keys; of lists none, as their entries have no
/// names.
void collect(const Document& object, const std::string& prefix, std::map<std::string, double>& numbers) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) collect(value, prefix + key + ".", numbers);
    if (value.is_number()) numbers[prefix + key] = value.get<double>();
  }
}

/// What the results of two studies say in single numbers.
void add_study_results(Document& beside, const Document& first, const Document& second) {
  const bool one = first.contains(study_results_key), other = second.contains(study_results_key);
  if (one != other) return cannot(beside, "results of the study", only_in(beside, one));
  if (!one) return;
  std::map<std::string, double> numbers, others;
  collect(first.at(study_results_key), "", numbers);
  collect(second.at(study_results_key), "", others);
  for (const auto& [key, value] : numbers) {
    if (const auto found = others.find(key); found == others.end())
      cannot(beside, key, only_in(beside, true));
    else
      beside["numbers"].push_back({{"name", key},
                                   {"unit", ""},
                                   {"first", value},
                                   {"second", found->second},
                                   {"difference", found->second - value}});
  }
  for (const auto& [key, value] : others)
    if (!numbers.contains(key)) cannot(beside, key, only_in(beside, false));
}

/// Numbers of a probe and the times they are of; what is not finite is left out.
struct Curve {
  std::vector<double> times, values;
};

Curve curve_of(const Document& probes, const std::string& column) {
  Curve curve;
  const Document &times = probes.at("t").at("values"), &values = probes.at(column).at("values");
  for (std::size_t i = 0; i < times.size() && i < values.size(); ++i) {
    if (!times[i].is_number() || !values[i].is_number()) continue;
    curve.times.push_back(times[i].get<double>());
    curve.values.push_back(values[i].get<double>());
  }
  return curve;
}

void add_distance(Document& beside, const std::string& column, const std::string& unit, const Curve& one,
                  const Curve& other) {
  if (one.times.empty() || other.times.empty())
    return cannot(beside, column, "there are no numbers in one of them");
  if (!is_rising(one.times) || !is_rising(other.times))
    return cannot(beside, column, "the times of one of them do not rise");
  const double from = std::max(one.times.front(), other.times.front()),
               to = std::min(one.times.back(), other.times.back());
  std::set<double> times;
  for (const std::vector<double>* own : {&one.times, &other.times})
    std::copy_if(own->begin(), own->end(), std::inserter(times, times.end()),
                 [&](double t) { return t >= from && t <= to; });
  if (times.size() < 2) return cannot(beside, column, "they have no span of time in common");
  const TimeInterpolation first(one.times, one.values), second(other.times, other.values);
  double greatest = 0, when = from, largest = 0;
  for (const double t : times) {
    const double a = first.value(t), distance = std::abs(second.value(t) - a);
    largest = std::max(largest, std::abs(a));
    if (distance <= greatest) continue;
    greatest = distance;
    when = t;
  }
  beside["probes"].push_back({{"column", column},
                              {"unit", unit},
                              {"from", from},
                              {"to", to},
                              {"greatest", greatest},
                              {"time", when},
                              {"largest", largest},
                              {"interpolated", one.times != other.times}});
}

void add_probes(Document& beside, const Document& first, const Document& second) {
  beside["probes"] = Document::array();
  const Document &one = first.at("probes"), &other = second.at("probes");
  for (const auto& [column, probe] : one.items()) {
    if (column == "t") continue;
    const std::string unit = text_of(probe, "unit");
    if (!other.contains(column))
      cannot(beside, column, only_in(beside, true));
    else if (other.at(column).at("unit") != unit)
      cannot(beside, column, fmt::format("in {} and in {}", unit, text_of(other.at(column), "unit")));
    else
      add_distance(beside, column, unit, curve_of(one, column), curve_of(other, column));
  }
  for (const auto& [column, probe] : other.items())
    if (column != "t" && !one.contains(column)) cannot(beside, column, only_in(beside, false));
}

std::string with_unit(const Document& value, const std::string& unit) {
  if (value.is_number_integer()) return std::to_string(value.get<long>()) + unit_after(unit);
  if (!value.is_number()) return "–";
  return fmt::format("{:.4g}{}", value.get<double>(), unit_after(unit));
}

/// "the tolerance of published: mid.y differs, 0.01 m and 0.001 m", or how many differ; empty: none.
std::string tolerances_in_words(const Document& beside) {
  std::vector<const Document*> differing;
  for (const Document& verdict : beside.at("verdicts"))
    if (verdict.at("first").at("limit") != verdict.at("second").at("limit")) differing.push_back(&verdict);
  if (differing.empty()) return "";
  const Document& one = *differing.front();
  const auto limit = [&](const char* side) {
    return with_unit(one.at(side).at("limit"), text_of(one, "unit"));
  };
  const std::string limits = fmt::format("{} in {} and {} in {}", limit("first"), text_of(beside, "first"),
                                         limit("second"), text_of(beside, "second"));
  return differing.size() == 1
             ? fmt::format("; the tolerance of {} differs, {}", text_of(one, "name"), limits)
             : fmt::format("; {} tolerances differ, that of {} is {}", differing.size(), text_of(one, "name"),
                           limits);
}

std::string headline_of(const Document& beside) {
  const Document &verdicts = beside.at("verdicts"), &probes = beside.at("probes");
  const auto otherwise = std::count_if(verdicts.begin(), verdicts.end(), [](const Document& verdict) {
    return verdict.at("first").at("status") != verdict.at("second").at("status");
  });
  std::string text =
      verdicts.empty() ? std::string("They have no criterion in common")
      : otherwise == 0
          ? fmt::format("{} alike", verdicts.size() == 1
                                        ? "The one shared criterion ends"
                                        : fmt::format("All {} shared criteria end", verdicts.size()))
          : fmt::format("{} of {} shared criteria {} differently", otherwise, verdicts.size(),
                        otherwise == 1 ? "ends" : "end");
  text += tolerances_in_words(beside);
  const auto share = [](const Document& probe) {
    const double largest = probe.at("largest").get<double>();
    return probe.at("greatest").get<double>() / (largest > 0 ? largest : 1);
  };
  const auto farthest =
      std::max_element(probes.begin(), probes.end(),
                       [&](const Document& a, const Document& b) { return share(a) < share(b); });
  if (farthest == probes.end())
    text += "; no curve is in both";
  else if (farthest->at("greatest") == 0)
    text += probes.size() == 1 ? "; the one shared curve is identical" : "; all curves are identical";
  else
    text += fmt::format("; of the shared curves {} is farthest apart, {:.3g}{} at {:.4g} s",
                        text_of(*farthest, "column"), farthest->at("greatest").get<double>(),
                        unit_after(text_of(*farthest, "unit")), farthest->at("time").get<double>());
  const std::size_t left = beside.at("not_compared").size();
  if (left > 0)
    text += fmt::format("; {} cannot be compared", counted(static_cast<long>(left), "thing", "things"));
  return text + ".";
}

/// "+1.2 m", or "the same".
std::string signed_text(const Document& value, const std::string& unit) {
  if (!value.is_number()) return "–";
  const double number = value.get<double>();
  if (number == 0) return "the same";
  // Counts are told whole.
  constexpr double most = 1e15;
  return (number == std::round(number) && std::abs(number) < most ? fmt::format("{:+.0f}", number)
                                                                  : fmt::format("{:+.3g}", number)) +
         unit_after(unit);
}

data rows_of(const Document& list, auto fill) {
  data rows{data::type::list};
  for (const Document& one : list) {
    data row;
    fill(row, one);
    rows.push_back(row);
  }
  return rows;
}

void set_side(data& row, const std::string& side, const Document& one, const std::string& unit) {
  const std::string status = text_of(one, "status");
  row[side + "_status"] = status;
  row[side + "_class"] = class_of_status(status);
  row[side + "_value"] = status == "not run" ? std::string("–") : with_unit(one.at("value"), unit);
}

}  // namespace

bool is_rising(const std::vector<double>& times) {
  return std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end();
}

Document beside_of(const Document& first, const std::string& first_name, const Document& second,
                   const std::string& second_name) {
  Document beside{{"first", first_name}, {"second", second_name}, {"headline", ""}};
  beside["case"] = case_differences(first.at("case"), second.at("case"));
  beside["not_compared"] = Document::array();
  add_verdicts(beside, first, second);
  add_numbers(beside, first, second);
  add_study_results(beside, first, second);
  add_probes(beside, first, second);
  beside["headline"] = headline_of(beside);
  return beside;
}

std::string beside_html(const Document& beside, const std::string& curves,
                        const std::vector<PicturePair>& pairs, std::size_t room) {
  data page;
  page["has_curves"] = !curves.empty();
  page["curves"] = curves;
  for (const char* key : {"first", "second", "headline"}) page[key] = text_of(beside, key);
  const auto set = [&](const char* key, auto fill) {
    const data rows = rows_of(beside.at(key), fill);
    page[std::string("has_") + key] = rows.is_non_empty_list();
    page.set(key, rows);
  };
  set("verdicts", [](data& row, const Document& one) {
    const std::string unit = text_of(one, "unit");
    row["name"] = text_of(one, "name");
    row["kind"] = text_of(one, "kind");
    set_side(row, "first", one.at("first"), unit);
    set_side(row, "second", one.at("second"), unit);
    const std::string limit = with_unit(one.at("first").at("limit"), unit),
                      other = with_unit(one.at("second").at("limit"), unit);
    row["allowed"] = limit == other ? limit : fmt::format("{} | {}", limit, other);
    row["difference"] = signed_text(one.at("difference"), unit);
  });
  set("numbers", [](data& row, const Document& one) {
    const std::string unit = text_of(one, "unit");
    row["name"] = text_of(one, "name");
    row["first_value"] = with_unit(one.at("first"), unit);
    row["second_value"] = with_unit(one.at("second"), unit);
    row["difference"] = signed_text(one.at("difference"), unit);
  });
  set("probes", [](data& row, const Document& one) {
    const std::string unit = text_of(one, "unit");
    row["column"] = text_of(one, "column");
    row["greatest"] = with_unit(one.at("greatest"), unit);
    row["largest"] = with_unit(one.at("largest"), unit);
    row["time"] = fmt::format("{:.4g}", one.at("time").get<double>());
    row["over"] = fmt::format("{:.4g} to {:.4g}", one.at("from").get<double>(), one.at("to").get<double>());
    row["how"] = one.at("interpolated").get<bool>() ? "interpolated between outputs" : "at the same outputs";
  });
  set("case", [](data& row, const Document& one) {
    for (const char* key : {"what", "before", "now"}) row[key] = text_of(one, key);
  });
  set("not_compared", [](data& row, const Document& one) {
    for (const char* key : {"what", "why"}) row[key] = text_of(one, key);
  });
  data pictures{data::type::list};
  long left_out = 0;
  for (const PicturePair& pair : pairs) {
    const std::string first = data_uri(pair.first), second = data_uri(pair.second);
    if (first.size() + second.size() > room) {
      ++left_out;
      continue;
    }
    room -= first.size() + second.size();
    data row;
    row["title"] = pair.title;
    row["first_uri"] = first;
    row["second_uri"] = second;
    pictures.push_back(row);
  }
  page["has_pictures"] = pictures.is_non_empty_list();
  page.set("pictures", pictures);
  page["left_out"] = left_out > 0 ? data(counted(left_out, "picture", "pictures")) : data(false);
  return fill_in(beside_mustache, page);
}

}  // namespace plumb
