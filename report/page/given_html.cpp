#include "report/page/given_html.h"

#include <fmt/format.h>

#include "report/base/document_value.h"
#include "report/figure/number_markup.h"
#include "report/page/page_template.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view given_mustache;
extern const std::string_view given_formulation_mustache;

namespace {

using kainjow::mustache::data;

data column_rows(const Document& given) {
  data rows{data::type::list};
  for (const auto& [name, column] : given.at("columns").items()) {
    data row;
    row["column"] = name;
    row["file_column"] = text_of(column, "file_column");
    row["file_unit"] = text_of(column, "file_unit");
    row["unit"] = unit_text(text_of(column, "unit"));
    rows.push_back(row);
  }
  return rows;
}

data distance_rows(const Document& given) {
  data rows{data::type::list};
  if (!given.contains("distances")) return rows;
  for (const Document& distance : given.at("distances")) {
    const bool any = distance.at("points").get<long>() > 0;
    data row;
    row["column"] = text_of(distance, "column");
    row["unit"] = unit_text(text_of(distance, "unit"));
    row["points"] = fmt::format("{} of {}", distance.at("points").get<long>(),
                                distance.at("coverage").at("demanded").get<long>());
    row["max"] = any ? four_digits(distance.at("max")) : "not run";
    row["max_time"] = any ? four_digits(distance.at("max_time")) : "–";
    row["rms"] = any ? four_digits(distance.at("rms")) : "not run";
    rows.push_back(row);
  }
  return rows;
}

/// The times that the case states for a run and its points; empty where it states none.
std::string speed_in_words(const Document& given) {
  if (!given.contains("threads")) return "";
  std::string times;
  const auto add = [&](const Document& seconds, const std::string& of) {
    times += fmt::format("{}{} s{}", times.empty() ? "" : ", ", four_digits(seconds), of);
  };
  if (given.at("seconds").get<double>() > 0) add(given.at("seconds"), "");
  for (const Document& point : given.at("points"))
    add(point.at("seconds"), fmt::format(" ({})", text_of(point, "label")));
  const std::string machine = text_of(given, "machine");
  const bool has_yardstick = given.at("yardstick").get<double>() > 0;
  return fmt::format("Time that the case states, on {} of {}: {}.{}",
                     counted(given.at("threads").get<long>(), "thread", "threads"),
                     !machine.empty() ? machine
                     : has_yardstick  ? "another machine"
                                      : "this machine",
                     times,
                     has_yardstick ? fmt::format(" The yardstick (plumb yardstick) takes {} s there.",
                                                 four_digits(given.at("yardstick")))
                                   : "");
}

}  // namespace

std::string given_runs_html(const Document& document) {
  data runs{data::type::list};
  for (const Document& given : document.at("given_runs")) {
    data run;
    run["name"] = text_of(given, "name");
    run["file"] = text_of(given, "file");
    run["program"] = text_of(given, "program");
    run["has_program"] = !text_of(given, "program").empty();
    run["is_reported"] = given.at("reported").get<bool>();
    run["outputs"] = std::to_string(given.at("outputs").get<long>());
    run["first_time"] = four_digits(given.at("first_time"));
    run["last_time"] = four_digits(given.at("last_time"));
    // Documents of earlier versions do not have it.
    run["taken_for"] = given.contains("taken_for") ? text_of(given, "taken_for") : "";
    run["speed"] = speed_in_words(given);
    run["interpolated"] = text_of(given, "interpolated");
    data notes{data::type::list};
    for (const Document& note : given.at("notes")) notes.push_back(data{"note", note.get<std::string>()});
    run.set("notes", notes);
    run.set("columns", column_rows(given));
    run["has_distances"] = given.contains("distances") && !given.at("distances").empty();
    run.set("distances", distance_rows(given));
    run["reported"] = text_of(document, "reported");
    runs.push_back(run);
  }
  data page;
  page.set("runs", runs);
  return fill_in(given_mustache, page);
}

std::string given_formulation_html(const Document& document) {
  data page;
  page["reported"] = text_of(document, "reported");
  page["computed_by"] = text_of(document, "computed_by");
  return fill_in(given_formulation_mustache, page);
}

}  // namespace plumb
