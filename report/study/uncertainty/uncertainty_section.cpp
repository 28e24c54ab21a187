#include "report/study/uncertainty/uncertainty_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/study/uncertainty/uncertainty_json.h"
#include "report/figure/number_markup.h"
#include "report/page/page_template.h"
#include "report/study/uncertainty/uncertainty_figure.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view uncertainty_mustache;

namespace {

using kainjow::mustache::data;
using Json = Document;

constexpr const char* uncertainty_key = "uncertainty";
constexpr const char* uncertainty_figures_key = "uncertainty_figures";

std::string number(const Json& json) {
  return json.is_number() ? fmt::format("{:.2g}", json.get<double>()) : "not finite";
}

std::string part_text(const Json& part) {
  return part.contains("at_greatest_error") ? number(part.at("at_greatest_error")) : text_of(part, "state");
}

data part_cells(const Json& series) {
  data cells{data::type::list};
  for (const Json& part : series.at("parts")) {
    data cell;
    cell["value"] = part_text(part);
    cell["words"] = !part.contains("at_greatest_error");
    cells.push_back(cell);
  }
  return cells;
}

/// What was found, what accounts for it, and what could not be.
std::string finding_of(const Json& series) {
  std::string text = text_of(series, "finding");
  if (!text_of(series, "explanation").empty()) text += "; " + text_of(series, "explanation");
  if (!text_of(series, "shared_model").empty())
    text += "; what both leave out does not show: " + text_of(series, "shared_model");
  return text;
}

data series_rows(const Json& uncertainty) {
  const double k = uncertainty.at("coverage_factor").get<double>();
  data rows{data::type::list};
  for (const Json& series : uncertainty.at("series")) {
    const Json& u = series.at("validation_uncertainty_at_greatest");
    const std::string at_least = series.at("at_least").get<bool>() ? "≥ " : "";
    data row;
    row["name"] = fmt::format("{}: {}", text_of(series, "reference"), text_of(series, "column"));
    row["error"] = series.at("error_at_greatest").is_number()
                       ? fmt::format("{:+.3g}", series.at("error_at_greatest").get<double>())
                       : "not finite";
    row["time"] = fmt::format("{:.4g}", series.at("time_of_greatest").get<double>());
    row["unit"] = unit_text(text_of(series, "unit"));
    row.set("parts", part_cells(series));
    row["u"] = at_least + number(u);
    row["expanded"] = u.is_number() ? at_least + fmt::format("{:.2g}", k * u.get<double>()) : "not finite";
    row["share"] = fmt::format("{:.0f} %", 100 * series.at("share_within").get<double>());
    row["finding"] = finding_of(series);
    rows.push_back(row);
  }
  return rows;
}

/// How each part was obtained, with the series that it holds for, each text once.
data how_rows(const Json& uncertainty) {
  struct How {
    std::string part, state, text, series;
  };
  std::vector<How> all;
  for (const Json& series : uncertainty.at("series"))
    for (const Json& part : series.at("parts")) {
      const std::string name = fmt::format("{}: {}", text_of(series, "reference"), text_of(series, "column"));
      const How how{text_of(part, "name"), text_of(part, "state"), text_of(part, "how"), name};
      const auto same = std::find_if(all.begin(), all.end(), [&](const How& other) {
        return other.part == how.part && other.state == how.state && other.text == how.text;
      });
      if (same == all.end())
        all.push_back(how);
      else
        same->series += ", " + name;
    }
  std::stable_sort(all.begin(), all.end(), [&](const How& a, const How& b) {
    const auto place = [&](const How& how) {
      const auto first =
          std::find_if(all.begin(), all.end(), [&](const How& any) { return any.part == how.part; });
      return first - all.begin();
    };
    return place(a) < place(b);
  });
  data rows{data::type::list};
  for (const How& how : all) {
    data row;
    row["part"] = how.part;
    row["state"] = how.state;
    row["how"] = how.text;
    row["series"] = how.series;
    row["open"] = how.state == "not estimated";
    rows.push_back(row);
  }
  return rows;
}

data input_rows(const Json& sampling) {
  data rows{data::type::list};
  for (const Json& input : sampling.at("inputs")) {
    const double spread = input.at("spread").get<double>();
    data row;
    row["key"] = text_of(input, "key");
    row["value"] = fmt::format("{:.6g}", input.at("value").get<double>());
    row["spread"] = fmt::format(
        "{}{}", text_of(input, "distribution") == "normal" ? "standard deviation " : "± ",
        input.at("relative").get<bool>() ? fmt::format("{:g} %", 100 * spread) : fmt::format("{:g}", spread));
    row["distribution"] = text_of(input, "distribution");
    row["source"] = text_of(input, "source");
    rows.push_back(row);
  }
  return rows;
}

data text_rows(const Json& texts) {
  data rows{data::type::list};
  for (const Json& text : texts) rows.push_back(data{"text", text.get<std::string>()});
  return rows;
}

void add_uncertainty(std::vector<Verdict>& verdicts, const std::vector<SeriesError>& errors, const Case& spec,
                     const Uncertainty& uncertainty) {
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const SeriesError& error = errors[k];
    const auto series =
        std::find_if(uncertainty.series.begin(), uncertainty.series.end(), [&](const SeriesUncertainty& any) {
          return any.reference == spec.references[error.reference].name && any.column == error.column;
        });
    if (error.given_run || error.exact || series == uncertainty.series.end() ||
        verdicts[k].status == VerdictStatus::not_run)
      continue;
    const std::string text = fmt::format(
        "; E = {:+.3g} {} with u_val {}{:.2g} {}: {}{}", series->error[series->greatest], series->unit,
        series->whole() ? "" : "≥ ", series->validation[series->greatest], series->unit, series->finding,
        series->explanation.empty() ? "" : "; " + series->explanation);
    verdicts[k].detail += text;
    verdicts[k].message += text;
  }
}

/// "2 of 6 comparisons stay within their uncertainty (2 u ≥ 0.01 m at most) at all times; published:
/// tip.x is beyond it most often, at 21 % of the times".
std::string uncertainty_in_words(const Json& uncertainty) {
  const Json& all = uncertainty.at("series");
  const double k = uncertainty.at("coverage_factor").get<double>();
  double greatest = -1, least_share = 2;
  std::string unit, worst;
  bool at_least = false;
  long within = 0;
  for (const Json& series : all) {
    const Json& u = series.at("validation_uncertainty_at_greatest");
    const double share = series.at("share_within").get<double>();
    within += share >= 1 ? 1 : 0;
    at_least = at_least || series.at("at_least").get<bool>();
    if (u.is_number() && k * u.get<double>() > greatest) {
      greatest = k * u.get<double>();
      unit = text_of(series, "unit");
    }
    if (share < least_share) {
      least_share = share;
      worst = fmt::format("{}: {}", text_of(series, "reference"), text_of(series, "column"));
    }
  }
  std::string text = fmt::format("{} of {} {} within {} uncertainty", within,
                                 counted(std::ssize(all), "comparison", "comparisons"),
                                 within == 1 ? "stays" : "stay", within == 1 ? "its" : "their");
  if (greatest >= 0)
    text += fmt::format(" ({:g} u {} {:.2g} {} at most)", k, at_least ? "≥" : "=", greatest, unit);
  text += " at all times";
  if (within < std::ssize(all))
    text +=
        fmt::format("; {} is beyond it most often, at {:.0f} % of the times", worst, 100 * (1 - least_share));
  return text;
}

std::string uncertainty_clause(const Document& document) {
  const Document& uncertainty = document.at(uncertainty_key);
  return uncertainty.at("series").empty() ? "" : uncertainty_in_words(uncertainty);
}

std::string uncertainty_html(const Document& uncertainty, const std::vector<Picture>& pictures) {
  const Json& sampling = uncertainty.at("sampling");
  data values;
  values["standard"] = text_of(uncertainty, "standard");
  values["k"] = fmt::format("{:g}", uncertainty.at("coverage_factor").get<double>());
  values["runs"] = std::to_string(uncertainty.at("runs").get<int>());
  values["seconds"] = fmt::format("{:.2g}", uncertainty.at("seconds").get<double>());
  values["in_words"] =
      uncertainty.at("series").empty() ? std::string() : uncertainty_in_words(uncertainty) + ".";
  values["has_series"] = !uncertainty.at("series").empty();
  values.set("series", series_rows(uncertainty));
  data names{data::type::list};
  if (!uncertainty.at("series").empty())
    for (const Json& part : uncertainty.at("series")[0].at("parts"))
      names.push_back(data{"name", text_of(part, "name")});
  values["part_count"] = std::to_string(names.list_value().size());
  values.set("part_names", names);
  values.set("hows", how_rows(uncertainty));
  values.set("pictures", picture_rows(pictures));
  values["has_inputs"] = !sampling.at("inputs").empty();
  values.set("inputs", input_rows(sampling));
  const int samples = sampling.at("samples").get<int>(), completed = sampling.at("completed").get<int>();
  values["samples"] = std::to_string(samples);
  values["completed"] = std::to_string(completed);
  values["failed"] = std::to_string(sampling.at("failures").size());
  values["has_failures"] = !sampling.at("failures").empty();
  values.set("failures", text_rows(sampling.at("failures")));
  values["has_left_out"] = !uncertainty.at("left_out").empty();
  values.set("left_out", text_rows(uncertainty.at("left_out")));
  return fill_in(uncertainty_mustache, values);
}

}  // namespace

RunSection uncertainty_section(const Uncertainty& uncertainty, const Case& spec) {
  const Figure figure = uncertainty_figure(uncertainty);
  return {.key = uncertainty_key,
          .json = uncertainty_json(uncertainty),
          .figures_key = uncertainty_figures_key,
          .drawing_stage = "uncertainty figure",
          .figures =
              [figure] { return figure.plot.panels.empty() ? std::vector<Figure>{} : std::vector{figure}; },
          .judge =
              [uncertainty, spec](std::vector<Verdict>& verdicts, const std::vector<SeriesError>& errors) {
                add_uncertainty(verdicts, errors, spec, uncertainty);
              }};
}

PageSection uncertainty_on_page() {
  return {.key = uncertainty_key,
          .id = "uncertainty",
          .link = "Uncertainty",
          .title = "Uncertainty of the comparisons",
          .html = uncertainty_html,
          .figures_key = uncertainty_figures_key,
          .clause = uncertainty_clause};
}

}  // namespace plumb
