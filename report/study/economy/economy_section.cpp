#include "report/study/economy/economy_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/codec.h"
#include "engine/study/economy/candidates.h"
#include "engine/study/economy/economy_json.h"
#include "report/page/page_template.h"
#include "report/study/economy/economy_figure.h"
#include "report/study/economy/economy_text.h"

namespace plumb {

extern const std::string_view economy_mustache;

namespace {

using kainjow::mustache::data;

constexpr const char* economy_key = "economy";

std::string cost(const TriedCandidate& tried) {
  return tried.seconds < 0 ? "not run" : fmt::format("{:.3g} ms", 1e3 * tried.seconds);
}

data candidate_rows(const Economy& economy) {
  data rows{data::type::list};
  for (std::size_t k = 0; k < economy.tried.size(); ++k) {
    const TriedCandidate& tried = economy.tried[k];
    data row;
    row["name"] = in_words(tried.candidate);
    row["cost"] = cost(tried);
    row["estimate"] = tried.estimate < 0 ? "–" : pixels_in_words(tried.estimate);
    row["why"] = tried.why;
    row["chosen"] = static_cast<int>(k) == economy.chosen;
    rows.push_back(row);
  }
  return rows;
}

Document economy_document(const Economy& economy, const SceneSpec& scene) {
  Document json = to_stored(economy);
  const TriedCandidate* choice = economy.choice();
  json["in_words"] = economy_sentence(economy, scene);
  json["needs"] = choice ? in_words(choice->candidate) : "";
  if (choice)
    json["picture_error"] =
        json["tried"][static_cast<std::size_t>(economy.chosen)]["estimated_picture_error"];
  json["explained"] = explain(economy);
  return json;
}

std::string economy_html(const Document& document, const std::vector<Picture>&) {
  const auto economy = decoded<Economy>(document);
  data section;
  section["sentence"] = document.at("in_words").get<std::string>();
  section["good"] = economy.holds;
  section["candidates"] = candidate_rows(economy);
  section["safety"] = fmt::format("{:g}", economy_safety);
  section["tolerance"] = fmt::format("{:g}", economy.tolerance);
  data notes{data::type::list};
  const auto& lines = document.at("explained");
  for (std::size_t k = economy.tried.size(); k < lines.size(); ++k)
    notes.push_back(data{"note", lines[k].get<std::string>()});
  section.set("notes", notes);
  return fill_in(economy_mustache, section);
}

/// Adds a verdict at the end.
auto adding(const Verdict& verdict) {
  return [verdict](std::vector<Verdict>& verdicts, const std::vector<SeriesError>&) {
    verdicts.push_back(verdict);
  };
}

}  // namespace

std::vector<RunSection> economy_sections(const Run& run, const std::optional<Economy>& economy) {
  const SceneSpec& scene = run.loaded.spec.scene;
  if (!economy) {
    const auto left = [](const auto& entry) { return entry.first == left_to_scene; };
    if (std::none_of(run.provenance.begin(), run.provenance.end(), left)) return {};
    return {{.judge = adding(verdict_without_choice(scene.tolerance))}};
  }
  const Verdict verdict = economy_verdict(*economy);
  return {{.key = economy_key,
           .json = economy_document(*economy, scene),
           .figures_key = figures_key,
           .figures = [found = *economy] { return std::vector{economy_figure(found)}; },
           .judge = adding(verdict),
           .sentence = fmt::format(" Picture error: {}, {}.", word(verdict.status), verdict.message)}};
}

PageSection economy_on_page() {
  return {.key = economy_key,
          .place = PagePlace::cost,
          .id = "economy",
          .link = "What the scene needs",
          .title = "What the scene needs",
          .html = economy_html};
}

}  // namespace plumb
