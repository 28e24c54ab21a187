#include "report/study/sensitivity/sensitivity_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/figure/number_markup.h"
#include "report/page/page_template.h"
#include "report/study/sensitivity/sensitivity_figure.h"
#include "report/study/sensitivity/sensitivity_results.h"

namespace plumb {

extern const std::string_view sensitivity_mustache;

namespace {

using kainjow::mustache::data;

constexpr const char* sensitivity_key = "sensitivity";
constexpr const char* sensitivity_figures_key = "sensitivity_figures";

/// Places of the criteria that were asked.
std::vector<std::size_t> asked_of(const Document& criteria) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < criteria.size(); ++k)
    if (criteria[k].at("met").get<bool>()) places.push_back(k);
  return places;
}

data criterion_heads(const Document& criteria, const std::vector<std::size_t>& asked) {
  data heads{data::type::list};
  for (const std::size_t k : asked) {
    data head;
    head["name"] = text_of(criteria[k], "name");
    head["limit"] = fmt::format("≤ {:.3g}{}", criteria[k].at("limit").get<double>(),
                                unit_after(text_of(criteria[k], "unit")));
    heads.push_back(head);
  }
  return heads;
}

data number_rows(const Document& numbers, const std::vector<std::size_t>& asked) {
  data rows{data::type::list};
  for (const Document& number : numbers) {
    data row, cells{data::type::list}, ends{data::type::list};
    row["words"] = text_of(number, "words");
    row["key"] = text_of(number, "key");
    for (const std::size_t k : asked) {
      data cell, sides{data::type::list};
      for (const bool up : {true, false}) {
        const Document& noticed = number.at(up ? "up" : "down").at("noticed").at(k);
        data side;
        side["text"] = change_text(noticed, up);
        side["nothing"] = noticed.at("change").get<double>() < 0;
        sides.push_back(side);
      }
      cell.set("sides", sides);
      cells.push_back(cell);
    }
    row.set("cells", cells);
    for (const bool up : {true, false}) {
      const Document& side = number.at(up ? "up" : "down");
      if (const std::string ended = text_of(side, "ended"); !ended.empty())
        ends.push_back(
            data{"text", fmt::format("{} to {} {:.3g} only: {}", up ? "up" : "down", up ? "×" : "÷",
                                     1 + side.at("searched").get<double>(), ended)});
    }
    row.set("ends", ends);
    rows.push_back(row);
  }
  return rows;
}

data blunder_rows(const Document& blunders, const Document& criteria, const std::vector<std::size_t>& asked) {
  data rows{data::type::list};
  for (const Document& blunder : blunders) {
    const std::string why_not = text_of(blunder, "why_not"), outcome = text_of(blunder, "outcome");
    const bool completed = outcome == "completed";
    data row, cells{data::type::list}, changes{data::type::list};
    row["name"] = text_of(blunder, "name");
    row["more_right"] = text_of(blunder, "kind") == "double-mesh";
    for (const Document& change : blunder.at("overrides"))
      changes.push_back(data{"change", change.get<std::string>()});
    row.set("changes", changes);
    row["applies"] = why_not.empty();
    row["why_not"] = why_not;
    row["columns"] = std::to_string(asked.size());
    row["told"] = completed;
    row["message"] = fmt::format("{}: {}", outcome, text_of(blunder, "message"));
    if (completed)
      for (const std::size_t k : asked) {
        const Document& found = blunder.at("found").at(k);
        const bool noticed = found.at("noticed").get<bool>();
        const Document& value = found.at("value");
        data cell;
        cell["class"] = noticed ? "passed" : "not-run";
        cell["text"] = noticed ? "noticed" : "not noticed";
        cell["value"] = !value.is_number()        ? std::string("not finite")
                        : value.get<double>() < 0 ? std::string("not judged")
                                                  : fmt::format("{:.2g}{}", value.get<double>(),
                                                                unit_after(text_of(criteria[k], "unit")));
        cells.push_back(cell);
      }
    row.set("cells", cells);
    rows.push_back(row);
  }
  return rows;
}

std::string sensitivity_html(const Document& found, const std::vector<Picture>& pictures) {
  const Document& criteria = found.at("criteria");
  const std::vector<std::size_t> asked = asked_of(criteria);
  const double largest = found.at("largest").get<double>();
  data values, sentences{data::type::list};
  values["left_out"] = text_of(found, "left_out");
  values["done"] = text_of(found, "left_out").empty();
  values["largest"] = fmt::format("{:g}", largest);
  values["time_limit"] = fmt::format("{:g}", found.at("time_limit").get<double>());
  values["runs"] = std::to_string(found.at("runs").get<long>());
  values["seconds"] = two_digits(found.at("seconds").get<double>());
  for (const Document& criterion : criteria) {
    data sentence;
    sentence["text"] = text_of(criterion, "in_words");
    sentence["weak"] = criterion.at("weak").get<bool>();
    sentences.push_back(sentence);
  }
  values.set("sentences", sentences);
  if (text_of(found, "left_out").empty()) {
    values.set("heads", criterion_heads(criteria, asked));
    values.set("numbers", number_rows(found.at("numbers"), asked));
    values["has_numbers"] = !found.at("numbers").empty();
    values.set("blunders", blunder_rows(found.at("blunders"), criteria, asked));
    values["has_blunders"] = !found.at("blunders").empty();
  }
  values.set("pictures", picture_rows(pictures));
  return fill_in(sensitivity_mustache, values);
}

std::string sensitivity_line(const Document& found) {
  if (const std::string why = text_of(found, "left_out"); !why.empty())
    return fmt::format("What the criteria notice was not tried: {}.", why);
  std::string text;
  for (const Document& criterion : found.at("criteria"))
    text += fmt::format("{}{}", text.empty() ? "" : "\n", text_of(criterion, "in_words"));
  return text;
}

}  // namespace

RunSection sensitivity_section(const Sensitivity& found) {
  RunSection section{.key = sensitivity_key,
                     .json = sensitivity_document(found),
                     .figures_key = sensitivity_figures_key,
                     .drawing_stage = "sensitivity figure"};
  if (!found.left_out.empty()) return section;
  if (!found.numbers.empty()) section.figures = [found] { return std::vector{sensitivity_figure(found)}; };
  section.judge = [weak = found.weak_names()](std::vector<Verdict>& verdicts,
                                              const std::vector<SeriesError>&) {
    for (Verdict& verdict : verdicts) {
      if (std::find(weak.begin(), weak.end(), verdict.name) == weak.end()) continue;
      constexpr const char* remark =
          "; weak: it notices no number of the model within a factor of two, and no blunder";
      verdict.detail += remark;
      verdict.message += remark;
    }
  };
  if (const std::string weak = weak_in_words(found); !weak.empty()) section.sentence = " " + weak;
  return section;
}

PageSection sensitivity_on_page() {
  return {.key = sensitivity_key,
          .id = "sensitivity",
          .link = "What is noticed",
          .title = "What the criteria would notice",
          .html = sensitivity_html,
          .figures_key = sensitivity_figures_key,
          .line = sensitivity_line};
}

}  // namespace plumb
