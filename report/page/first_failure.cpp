#include "report/page/first_failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/image/apng.h"
#include "report/base/document_value.h"
#include "report/page/page_template.h"

namespace plumb {

extern const std::string_view first_failure_mustache;

namespace {

using kainjow::mustache::data;

constexpr std::size_t most_others = 6;

/// The failed verdicts, what moved since the baseline first, and then by how much of what is allowed was
/// found; a value that is no number is worse than any.
std::vector<Verdict> failed_first(const Document& document) {
  std::vector<Verdict> failed = verdicts_of(document);
  std::erase_if(failed, [](const Verdict& verdict) { return verdict.status != VerdictStatus::failed; });
  const auto share = [](const Verdict& verdict) {
    const double value = verdict.value / verdict.limit;
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::stable_sort(failed.begin(), failed.end(), [&](const Verdict& a, const Verdict& b) {
    const auto moved = [](const Verdict& verdict) {
      return verdict.kind == VerdictKind::regression && verdict.time >= 0;
    };
    return moved(a) != moved(b) ? moved(a) : share(a) > share(b);
  });
  return failed;
}

std::string how_far(const Verdict& verdict) {
  const std::string unit = verdict.unit == "1" ? "" : " " + verdict.unit;
  if (!std::isfinite(verdict.value)) return "no finite number was found";
  std::string text = fmt::format("{}{} found, {}{} allowed", four_digits(verdict.value), unit,
                                 four_digits(verdict.limit), unit);
  if (verdict.limit > 0)
    text += fmt::format(": {} times as much", four_digits(verdict.value / verdict.limit));
  return text;
}

/// The frame of the animation on the page that is next to a time (s).
void set_frame(data& values, const Pictures& pictures, double time) {
  values["has_frame"] = false;
  if (!pictures.animated() || !(time >= 0) || !(pictures.player_frame_rate > 0)) return;
  const std::vector<std::string> frames = split_apng(pictures.page_animation, player_file);
  const auto last = static_cast<double>(frames.size() - 1);
  const double place = std::clamp(std::round(time * pictures.player_frame_rate), 0.0, last);
  values["has_frame"] = true;
  values["frame"] = data_uri(frames[static_cast<std::size_t>(place)]);
  const std::string shown = fmt::format("{:.4g}", place / pictures.player_frame_rate),
                    wished = fmt::format("{:.4g}", time);
  values["frame_time"] = shown;
  values["stands_for"] = shown == wished ? data(false) : data(wished);
  values["width"] = std::to_string(pictures.page_animation_width);
  values["height"] = std::to_string(pictures.page_animation_height);
}

}  // namespace

std::string first_failure_html(const Document& document, const Pictures& pictures) {
  data values, others{data::type::list};
  if (!document.at("complete").get<bool>()) {
    const Document& solve = document.at("solve");
    const double end = solve.at("end_time").get<double>();
    values["title"] = fmt::format("How it ended: {}", solve.at("outcome").get<std::string>());
    set_frame(values, pictures, end);
    // The headline says the rest.
    if (!values["has_frame"].is_true()) return "";
    const std::string shown = values["frame_time"].string_value();
    values["what"] =
        fmt::format("The run broke off at {:.4g} s; the picture is the last one of it, at {} s{}.", end,
                    shown, shown == "0" ? ", its start" : "");
    values["stands_for"] = false;
    return fill_in(first_failure_mustache, values);
  }
  const std::vector<Verdict> failed = failed_first(document);
  if (failed.empty()) return "";
  const Verdict& first = failed.front();
  const bool moved = first.kind == VerdictKind::regression;
  values["title"] = moved ? "What moved" : "The worst miss";
  values["name"] = first.name;
  values["what"] = how_far(first) + ".";
  values["detail"] = first.detail;
  set_frame(values, pictures, first.time);
  for (std::size_t k = 1; k < std::min(failed.size(), most_others + 1); ++k) {
    data row;
    row["name"] = failed[k].name;
    row["what"] = how_far(failed[k]);
    others.push_back(row);
  }
  values["has_others"] = failed.size() > 1;
  values.set("others", others);
  values["more"] = failed.size() > most_others + 1
                       ? fmt::format("{} more are below.", failed.size() - most_others - 1)
                       : std::string();
  return fill_in(first_failure_mustache, values);
}

}  // namespace plumb
