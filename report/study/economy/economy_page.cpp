#include <fmt/format.h>

#include <cmath>

#include "engine/study/economy/candidates.h"
#include "report/page/page_template.h"
#include "report/study/economy/economy_figure.h"
#include "report/study/economy/economy_results.h"
#include "report/study/economy/economy_text.h"

namespace plumb {

extern const std::string_view economy_study_mustache;

namespace {

using kainjow::mustache::data;

data need_rows(const EconomyStudy& study) {
  data rows{data::type::list};
  for (const SceneNeed& need : study.needs) {
    const TriedCandidate* choice = need.economy.choice();
    if (choice == nullptr) continue;
    data row;
    row["name"] = need.name;
    row["chosen"] = in_words(choice->candidate);
    row["holds"] = need.economy.holds;
    row["tolerance"] = fmt::format("{:g}", need.economy.tolerance);
    row["estimate"] = pixels_in_words(choice->estimate);
    row["truth"] = pixels_in_words(choice->true_error);
    row["doubt"] = pixels_in_words(need.reference_doubt);
    row["worst"] = fmt::format("{:.2f}", need.worst_ratio());
    row["cost"] = fmt::format("{:.3g} ms", 1e3 * need.seconds);
    row["ratio"] = fmt::format("{:.0f}", cost_ratio(study, need));
    row["search"] = fmt::format("{:.2g}", need.economy.search_seconds / study.safe_seconds);
    rows.push_back(row);
  }
  return rows;
}

data explained(const EconomyStudy& study) {
  data rows{data::type::list};
  for (const SceneNeed& need : study.needs) {
    std::string lines;
    for (const std::string& line : explain(need.economy)) lines += line + "\n";
    data row;
    row["name"] = need.name;
    row["lines"] = lines;
    rows.push_back(row);
  }
  return rows;
}

enum class SceneRows { missed, unproven };

data scene_rows(const EconomyStudy& study, SceneRows which, long& count) {
  data rows{data::type::list};
  for (const RandomScene& scene : study.scenes) {
    if (which == SceneRows::missed ? !scene.missed() : scene.holds) continue;
    ++count;
    data row;
    row["number"] = std::to_string(scene.number);
    row["chosen"] = scene.chosen;
    row["tolerance"] = fmt::format("{:g}", scene.tolerance);
    row["estimate"] = pixels_in_words(scene.estimate);
    row["truth"] = pixels_in_words(scene.true_error);
    row["doubt"] = pixels_in_words(scene.reference_doubt);
    row["uncertain"] = scene.uncertain;
    row["command"] = command_of(study, scene);
    rows.push_back(row);
  }
  return rows;
}

/// True error over tolerance of the random scenes, by estimate over tolerance.
Figure scenes_figure(const EconomyStudy& study) {
  Panel panel;
  panel.x.label = "estimated picture error / tolerance";
  panel.y.label = "true picture error / tolerance";
  panel.x.scale = panel.y.scale = Scale::logarithmic;
  Series held, missed;
  held.label = "met";
  held.color = Color::hex(0x0072B2);
  held.marker = Marker::circle;
  held.line_width = 0;
  missed.label = "missed";
  missed.color = Color::hex(0xD55E00);
  missed.marker = Marker::cross;
  missed.line_width = 0;
  for (const RandomScene& scene : study.scenes) {
    if (!scene.holds || !(scene.estimate > 0) || !(scene.true_error > 0)) continue;
    Series& series = scene.missed() ? missed : held;
    series.x.push_back(scene.estimate / scene.tolerance);
    series.y.push_back(scene.true_error / scene.tolerance);
  }
  double lo = 0.1;
  for (const Series* series : {&held, &missed})
    for (std::size_t k = 0; k < series->x.size(); ++k) lo = std::min({lo, series->x[k], series->y[k]});
  lo = std::max(lo, 1e-4);
  Series alike;
  alike.label = "as estimated";
  alike.color = Color::hex(0x555555);
  alike.x = {lo, 1};
  alike.y = {lo, 1};
  panel.x.range = {lo / 1.5, 1.0};
  panel.y.range = {lo / 1.5, 2.0};
  panel.series.push_back(std::move(held));
  if (!missed.x.empty()) panel.series.push_back(std::move(missed));
  panel.series.push_back(std::move(alike));
  panel.rules.push_back(
      {.from = 1, .to = 1, .label = "tolerance", .color = Color::hex(0xD55E00), .dash = Dash::solid});
  Figure figure;
  figure.name = "economy_scenes";
  figure.title = fmt::format("{} random scenes: truth against estimate", study.scenes.size());
  figure.alt = figure.title;
  figure.plot.title = figure.title;
  figure.plot.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

std::vector<Figure> economy_study_figures(const EconomyStudy& study) {
  std::vector<Figure> figures;
  for (const SceneNeed& need : study.needs) {
    Figure figure = economy_figure(need.economy);
    figure.name = fmt::format("economy_{}", figures.size() + 1);
    figure.title = figure.plot.title = need.name;
    figures.push_back(std::move(figure));
  }
  if (!study.scenes.empty()) figures.push_back(scenes_figure(study));
  return figures;
}

StudySection shown_economy(const EconomyStudy& study, const std::vector<Picture>& pictures) {
  data section;
  section["reference"] = study.reference;
  section["safe_default"] = in_words(safe_candidate(study.loaded.spec));
  section["safe"] = fmt::format("{:.3g}", study.safe_seconds);
  section["safe_end"] = fmt::format("{:.3g}", study.safe_end);
  section["safe_whole"] = study.safe_end >= study.loaded.spec.time.end;
  section["safety"] = fmt::format("{:g}", economy_safety);
  section["needs"] = need_rows(study);
  section["explained"] = explained(study);
  section.set("figures", picture_rows(pictures));
  section["has_scenes"] = !study.scenes.empty();
  section["scenes"] = std::to_string(study.scenes.size());
  section["seed"] = std::to_string(study.spec.seed);
  long missed = 0, unproven = 0;
  section["missed"] = scene_rows(study, SceneRows::missed, missed);
  section["unproven"] = scene_rows(study, SceneRows::unproven, unproven);
  section["has_missed"] = missed > 0;
  section["has_unproven"] = unproven > 0;
  section["unproven_count"] = std::to_string(unproven);

  StudySection shown;
  shown.links = {{"needs", "What each picture needs"}};
  if (!study.scenes.empty()) shown.links.emplace_back("scenes", "Random scenes");
  shown.html = fill_in(economy_study_mustache, section);
  shown.verdict_note =
      "<strong>Verification</strong> holds a choice against a reference, <strong>performance</strong> its "
      "cost against that of the safe default.";
  return shown;
}

}  // namespace plumb
