#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "render/image/png_file.h"
#include "report/base/document_value.h"
#include "report/base/escape.h"
#include "report/figure/number_markup.h"
#include "report/figure/panels_json.h"
#include "report/index/comparisons.h"
#include "report/index/run_index.h"
#include "report/page/history_html.h"
#include "report/page/page_scripts.h"
#include "report/page/page_template.h"
#include "report/page/svg_chart.h"
#include "report/page/verdict_groups.h"
#include "report/page/verdict_html.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view index_mustache, index_css, figure_mustache, beside_css;
extern const std::string_view chart_min_js, chart_min_js_sha256, clock_js, clock_js_sha256;
extern const std::string_view charts_js, charts_js_sha256, beside_js, beside_js_sha256;
extern const std::string_view report_js, report_js_sha256, downloads_js, downloads_js_sha256;
extern const std::string_view tables_js, tables_js_sha256, index_js, index_js_sha256;

namespace {

using kainjow::mustache::data;

constexpr std::size_t most_thumbnail_bytes = 2'200'000;  // of a page, as data URIs
constexpr std::size_t most_pair_bytes = 2'600'000;       // likewise, of pictures beside one another
constexpr std::size_t most_histories = 60;
/// Of more reports, tables are laid out only as they are scrolled to.
constexpr std::size_t many_reports = 60;
/// Those that are read first.
constexpr std::array statuses{"failed", "not run", "another model", "passed"};

/// A path as the target of a link: what is not plain is escaped by percent signs.
std::string link_to(const std::string& path) {
  std::string link;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.' || c == '/' || c == '~';
    link += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return link + "/index.html";
}

/// What marks an element as one of a report.
void set_report(data& row, const Document& report) {
  row["folder"] = text_of(report, "folder");
  row["report"] = text_of(report, "name");
  row["link"] = link_to(text_of(report, "folder"));
  row["state"] = text_of(report, "state");
  row["class"] = class_of_status(text_of(report, "state"));
}

/// The thumbnails of the reports by their folders, as far as a page has room for them.
class Thumbnails {
 public:
  explicit Thumbnails(const std::vector<IndexedReport>& reports) {
    for (const IndexedReport& report : reports) pictures_[report.folder] = &report.thumbnail;
  }

  void set(data& row, const std::string& folder) {
    const auto found = pictures_.find(folder);
    row["thumbnail"] = false;
    if (found == pictures_.end() || found->second->empty()) return;
    const std::string uri = data_uri(*found->second);
    if (used_ + uri.size() > most_thumbnail_bytes) return;
    used_ += uri.size();
    const PngFile file = read_png_file(*found->second, folder);
    row["thumbnail"] = uri;
    row["thumbnail_width"] = std::to_string(file.width);
    row["thumbnail_height"] = std::to_string(file.height);
  }

 private:
  std::map<std::string, const std::string*> pictures_;
  std::size_t used_ = 0;
};

data report_row(const Document& report) {
  data row;
  set_report(row, report);
  row["method"] = text_of(report, "method");
  for (const char* key : {"criteria", "failed", "not_run", "elements", "exit_status"})
    row[key] = std::to_string(report.at(key).get<long>());
  // A study as a whole has none.
  if (report.at("elements") < 0) row["elements"] = "–";
  row["short"] = text_of(report, "outcome") + ": " + text_of(report, "outcome_reason");
  const double seconds = number_of(report.at("solve_seconds"));
  row["seconds"] = seconds >= 0 ? fmt::format("{:.3g} s", seconds) : "not run";
  row["kind"] = text_of(report, "kind").empty() ? "–" : text_of(report, "kind");
  return row;
}

bool has_failed(const Document& report) {
  const std::string state = text_of(report, "state");
  return state == "failed" || state == "failed to run" || state == "not run";
}

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}", value, unit_after(unit));
}

data verdict_row(const Document& verdict, const Document& report) {
  data row;
  set_report(row, report);
  const std::string status = text_of(verdict, "status"), unit = text_of(verdict, "unit");
  const double value = number_of(verdict.at("value")), limit = number_of(verdict.at("limit"));
  row["status"] = status;
  row["class"] = class_of_status(status);
  for (const char* key : {"name", "criterion", "detail"}) row[key] = text_of(verdict, key);
  row["found"] = status == "not run"    ? "not run"
                 : std::isfinite(value) ? with_unit(value, unit)
                                        : std::string("not finite");
  // Where nothing at all is allowed, or nothing is judged, there is no share of it.
  row["share"] = status == "not run" || status == "another model" || !(limit > 0) || !std::isfinite(value)
                     ? "–"
                     : fmt::format("{:.3g} %", 100 * value / limit);
  return row;
}

/// "2 failed, 30 passed"
std::string in_words(const std::map<std::string, long>& counts) {
  std::string words;
  for (const char* status : statuses)
    if (const auto found = counts.find(status); found != counts.end())
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", found->second, status);
  return words;
}

/// The verdicts of all reports by kind, within one those that failed first and then by report.
data kind_rows(const Document& index) {
  data rows{data::type::list};
  for (const KindText& text : kind_texts) {
    std::map<std::string, long> counts;
    data verdicts{data::type::list};
    const std::string kind(word(text.kind));
    for (const Document& report : index.at("reports"))
      for (const Document& verdict : report.at("verdicts"))
        if (verdict.at("kind") == kind) ++counts[text_of(verdict, "status")];
    for (const char* status : statuses)
      for (const Document& report : index.at("reports"))
        for (const Document& verdict : report.at("verdicts"))
          if (verdict.at("kind") == kind && verdict.at("status") == status)
            verdicts.push_back(verdict_row(verdict, report));
    if (counts.empty()) continue;
    data row;
    row["kind"] = kind;
    row["title"] = text.title;
    row["evidence"] = text.evidence;
    row["counts"] = in_words(counts);
    row.set("verdicts", verdicts);
    rows.push_back(row);
  }
  return rows;
}

/// "14 failed" and the like, of criteria, and the reports of which nothing is claimed.
data count_rows(const Document& index) {
  std::map<std::string, long> counts;
  long unheld = 0;
  for (const Document& report : index.at("reports")) {
    for (const Document& verdict : report.at("verdicts")) ++counts[text_of(verdict, "status")];
    unheld += report.at("state") == "not held against anything" ? 1 : 0;
  }
  data rows{data::type::list};
  const auto add = [&](long count, const std::string& word, const std::string& css) {
    data row;
    row["count"] = std::to_string(count);
    row["word"] = word;
    row["class"] = css;
    rows.push_back(row);
  };
  for (const char* status : statuses)
    if (counts.contains(status)) add(counts[status], status, class_of_status(status));
  if (unheld > 0)
    add(unheld, unheld == 1 ? "report not held against anything" : "reports not held against anything",
        "not-held-against-anything");
  return rows;
}

/// What of a report that failed is to be read first: the criterion with the worst miss, by how much and
/// where, or how the run ended.
std::string what_failed(const Document& report) {
  const Document* worst = nullptr;
  double most = -1;
  for (const Document& verdict : report.at("verdicts")) {
    if (verdict.at("status") != "failed") continue;
    const double share = number_of(verdict.at("value")) / number_of(verdict.at("limit"));
    const double missed = std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
    if (worst != nullptr && missed <= most) continue;
    worst = &verdict;
    most = missed;
  }
  if (worst == nullptr || text_of(report, "state") == "failed to run")
    return fmt::format("{}: {}", text_of(report, "outcome"), text_of(report, "outcome_reason"));
  const std::string unit = text_of(*worst, "unit");
  const double value = number_of(worst->at("value"));
  std::string text =
      fmt::format("{}: {} found, {} allowed", text_of(*worst, "name"),
                  std::isfinite(value) ? with_unit(value, unit) : std::string("no finite number"),
                  with_unit(number_of(worst->at("limit")), unit));
  if (worst->value("time", -1.0) >= 0) text += fmt::format(", at {:.4g} s", number_of(worst->at("time")));
  return text;
}

/// The reports that failed, and then the others by the kind of their evidence.
data group_rows(const Document& index, Thumbnails& thumbnails) {
  struct Group {
    std::string kind, title, evidence;
  };
  std::vector<Group> groups{{"failed", "Failed first", "The worst miss of each, or how its run ended."}};
  for (const KindText& text : kind_texts)
    groups.push_back({std::string(word(text.kind)), text.title, text.evidence});
  groups.push_back({"", "Not held against anything", ""});
  data rows{data::type::list};
  for (const Group& group : groups) {
    const bool of_failed = group.kind == "failed";
    data reports{data::type::list};
    long count = 0;
    for (const Document& report : index.at("reports")) {
      if (has_failed(report) != of_failed || (!of_failed && report.at("kind") != group.kind)) continue;
      data row;
      set_report(row, report);
      row["what"] = of_failed ? what_failed(report) : std::string();
      row["has_what"] = of_failed;
      thumbnails.set(row, text_of(report, "folder"));
      reports.push_back(row);
      ++count;
    }
    if (count == 0) continue;
    data row;
    row["title"] = group.title;
    row["evidence"] = group.evidence;
    row["count"] = counted(count, "report", "reports");
    row["wide"] = of_failed;
    row.set("reports", reports);
    rows.push_back(row);
  }
  return rows;
}

std::string share_in_words(const Document& value) {
  return value.is_number() ? fmt::format("{:.3g} %", 100 * value.get<double>()) : "–";
}

data statistics_rows(const Document& index) {
  data rows{data::type::list};
  for (const Document& one : index.at("statistics")) {
    data row;
    row["kind"] = text_of(one, "kind");
    row["class"] = class_of_status(text_of(one, "kind"));
    for (const char* key : {"comparisons", "left_out"}) row[key] = std::to_string(one.at(key).get<long>());
    row["bias"] = one.at("bias").is_number() ? fmt::format("{:.7g}", one.at("bias").get<double>()) : "–";
    row["spread"] = share_in_words(one.at("spread"));
    row["reference_spread"] = (one.at("reference_spread_is_bound").get<bool>() ? "≤ " : "") +
                              share_in_words(one.at("reference_spread"));
    rows.push_back(row);
  }
  return rows;
}

/// A mark for a pair of a comparison; `which` is "greatest" or "farthest".
SvgMark mark_of(const Document& comparison, const char* which) {
  const Document& pair = comparison.at(which);
  const std::string kind = text_of(comparison, "kind"), unit = text_of(comparison, "unit"),
                    folder = text_of(comparison, "folder");
  const double reference = number_of(pair.at("reference")), predicted = number_of(pair.at("predicted"));
  SvgMark mark;
  mark.x = std::abs(reference);
  mark.y = std::abs(predicted);
  mark.css = class_of_status(kind);
  mark.hollow = std::string_view(which) == "farthest";
  mark.title = fmt::format(
      "{}: {}\npredicted {} for {}\n{}{}", folder, text_of(comparison, "name"), with_unit(predicted, unit),
      with_unit(reference, unit), 100 * std::abs(predicted / reference - 1), kind,
      mark.hollow ? ", where they are farthest apart" : ", where the reference is greatest");
  mark.data = fmt::format("data-case=\"{}\" data-kind=\"{}\"", escape_xml(folder), escape_xml(kind));
  // Of several marks one leads there: it is enough for who goes by the keyboard.
  if (!mark.hollow) mark.link = link_to(folder);
  return mark;
}

/// Marks of all pairs that have a ratio, the farthest, where they are others, below the rest.
std::vector<SvgMark> marks_of(const Document& comparisons) {
  std::vector<SvgMark> marks;
  for (const char* which : {"farthest", "greatest"})
    for (const Document& comparison : comparisons) {
      const Document &pair = comparison.at(which), &greatest = comparison.at("greatest");
      if (has_ratio(pair.at("reference"), pair.at("predicted")) && (&pair == &greatest || pair != greatest))
        marks.push_back(mark_of(comparison, which));
    }
  return marks;
}

std::string scatter_of(const Document& index) {
  SvgChart chart;
  chart.width = 560;
  chart.height = 480;
  chart.marks = marks_of(index.at("comparisons"));
  std::vector<double> values;
  for (const SvgMark& mark : chart.marks) values.insert(values.end(), {mark.x, mark.y});
  chart.x = fitted_axis(values, true, "reference, in the unit of each");
  chart.y = chart.x;
  chart.y.label = "predicted, in the same unit";
  chart.alt = fmt::format("Scatter of {} values that were predicted over those of their references.",
                          chart.marks.size());
  const double from = chart.x.from, to = chart.x.to;
  // y = factor · x as far as it is within the frame.
  const auto add = [&](double factor, const std::string& css) {
    const double begin = std::max(from, from / factor), end = std::min(to, to / factor);
    if (begin < end) chart.lines.push_back({{{begin, factor * begin}, {end, factor * end}}, css});
  };
  add(1, "same");
  for (const Document& one : index.at("statistics")) {
    if (!one.at("spread").is_number()) continue;
    const std::string of = " of-" + class_of_status(text_of(one, "kind"));
    const double bias = one.at("bias").get<double>(), spread = one.at("spread").get<double>();
    add(bias, "bias" + of);
    for (const double factor : {bias * (1 + 2 * spread), bias * (1 - 2 * spread)})
      if (factor > 0) add(factor, "band" + of);
  }
  return to_svg(chart);
}

/// How far the predictions are off, as shares, which tells what the scatter is too coarse for. Those that are
/// not off at all have no place on it.
std::string shares_of(const Document& index) {
  SvgChart chart;
  chart.width = 560;
  chart.height = 300;
  std::vector<double> references, shares;
  for (SvgMark& mark : marks_of(index.at("comparisons"))) {
    mark.y = std::abs(mark.y / mark.x - 1);
    mark.link.clear();
    // The rest is said by the same mark of the scatter.
    mark.title.resize(mark.title.find('\n'));
    mark.title += fmt::format("\n{:.2g} % off", 100 * mark.y);
    references.push_back(mark.x);
    shares.push_back(mark.y);
    chart.marks.push_back(std::move(mark));
  }
  chart.x = fitted_axis(references, true, "reference, in the unit of each");
  chart.y = fitted_axis(shares, true, "off by, of the reference");
  chart.alt = fmt::format("How far {} values that were predicted are off, as shares of their references.",
                          chart.marks.size());
  return to_svg(chart);
}

void set_history(data& page, const Document& index) {
  data rows{data::type::list};
  std::size_t shown = 0, left_out = 0;
  for (const Document& report : index.at("reports")) {
    if (!report.contains(history_key) || report.at(history_key).empty()) continue;
    if (shown == most_histories) {
      ++left_out;
      continue;
    }
    const std::string charts = history_in_small(report.at(history_key));
    if (charts.empty()) continue;
    ++shown;
    data row;
    row["folder"] = text_of(report, "folder");
    row["report"] = text_of(report, "name");
    row["charts"] = charts;
    rows.push_back(row);
  }
  page["has_history"] = shown > 0;
  page["history_left_out"] = left_out > 0 ? data(std::to_string(left_out)) : data(false);
  page.set("history", rows);
}

/// The figures of two runs as charts.
Document chart_data(const std::vector<Picture>& figures) {
  Document charts{{"figures", Document::array()}, {"end_time", 0}, {"frame_rate", 0}};
  for (const Picture& figure : figures) {
    charts["figures"].push_back({{"file", figure.file},
                                 {"title", figure.title},
                                 {"chart", true},
                                 {"panels", panels_json(figure.plot, figure.times)}});
    for (const Panel& panel : figure.plot.panels)
      for (const Series& series : panel.series)
        if (!series.x.empty())
          charts["end_time"] = std::max(charts["end_time"].get<double>(), series.x.back());
  }
  return charts;
}

}  // namespace

std::string index_page(const Document& index, const std::vector<Picture>& figures,
                       const std::vector<IndexedReport>& all, const std::vector<PicturePair>& pairs) {
  data page, reports{data::type::list}, unheld{data::type::list};
  const std::size_t count = index.at("reports").size();
  const std::string cases = fmt::format("{} report{}", count, count == 1 ? "" : "s");
  page["cases"] = cases;
  page["headline"] = text_of(index, "headline");
  if (index.contains("beside")) page["beside_headline"] = text_of(index.at("beside"), "headline");
  const auto is_state = [&](const char* state) {
    return [state](const Document& report) { return report.at("state") == state; };
  };
  const Document& list = index.at("reports");
  page["many"] = count > many_reports;
  page["mood"] = index.at("all_criteria_met").get<bool>() ? "good"
                 : std::any_of(list.begin(), list.end(), is_state("failed to run")) ||
                         std::any_of(list.begin(), list.end(), is_state("failed")) ||
                         std::any_of(list.begin(), list.end(), is_state("not run"))
                     ? "bad"
                     : "plain";
  page.set("counts", count_rows(index));
  Thumbnails thumbnails(all);
  for (const Document& report : list) {
    reports.push_back(report_row(report));
    if (report.at("state") != "not held against anything") continue;
    data row;
    set_report(row, report);
    unheld.push_back(row);
  }
  page.set("reports", reports);
  page.set("groups", group_rows(index, thumbnails));
  page["at_once"] =
      index.value("at_once", 0) > 1 ? data(std::to_string(index["at_once"].get<long>())) : data(false);
  page["has_comparisons"] = !index.at("statistics").empty();
  if (!index.at("statistics").empty()) {
    page["scatter"] = scatter_of(index);
    page["shares"] = shares_of(index);
  }
  page.set("statistics", statistics_rows(index));
  const data kinds = kind_rows(index);
  page["has_verdicts"] = kinds.is_non_empty_list();
  page.set("kinds", kinds);
  page["has_unheld"] = unheld.is_non_empty_list();
  page.set("unheld", unheld);
  set_history(page, index);
  std::string curves;
  for (const Picture& figure : figures) curves += fill_in(figure_mustache, picture_values(figure));
  page["figures"] = curves;
  std::vector<PageScript> scripts{{report_js, report_js_sha256},
                                  {downloads_js, downloads_js_sha256},
                                  {tables_js, tables_js_sha256},
                                  {index_js, index_js_sha256}};
  std::string css = std::string(history_css).append(index_css);
  Document own{{"figures", Document::array()}};
  const bool beside = index.contains("beside");
  page["has_beside"] = beside;
  page["has_figures"] = !figures.empty() && !beside;
  if (beside) {
    page["beside"] = beside_html(index.at("beside"), curves, pairs, most_pair_bytes);
    css += beside_css;
    own = chart_data(figures);
    scripts.insert(scripts.begin(), {chart_min_js, chart_min_js_sha256});
    scripts.insert(scripts.begin() + 2, {{clock_js, clock_js_sha256}, {charts_js, charts_js_sha256}});
    scripts.push_back({beside_js, beside_js_sha256});
  }
  return html_page(cases + " of Plumb", css, fill_in(index_mustache, page), scripts,
                   data_element("page-data", own.dump(-1, ' ', false, Document::error_handler_t::replace)));
}

}  // namespace plumb
