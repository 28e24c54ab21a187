#include "report/page/page.h"

#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/integrate/method_info.h"
#include "report/base/document_value.h"
#include "report/document/report_formats.h"
#include "report/page/changes_html.h"
#include "report/page/conclusion.h"
#include "report/page/first_failure.h"
#include "report/page/given_html.h"
#include "report/page/page_scripts.h"
#include "report/page/page_tables.h"
#include "report/page/page_template.h"
#include "report/page/reproduce.h"
#include "report/page/verdict_groups.h"

namespace plumb {

extern const std::string_view page_mustache, figure_mustache;
extern const std::string_view formulation_mustache;

namespace {

using kainjow::mustache::data;

const MethodInfo& method_of(const Document& the_case) {
  const std::string name = the_case.at("method").at("name").get<std::string>();
  const MethodInfo* info = find_method(name);
  if (!info) throw InputError("results.json: no method is called " + name);
  return *info;
}

std::string formulation_html(const Document& document) {
  const Document& the_case = document.at("case");
  if (document.contains("computed_by")) return given_formulation_html(document);
  const Document& cable = the_case.at("cable");
  const MethodInfo& method = method_of(the_case);
  data formulation;
  formulation["rigid"] = cable.at("model") == word(CableModel::rigid);
  formulation["chain"] = cable.at("model") == word(CableModel::chain);
  formulation["green"] = cable.at("strain") == word(StrainModel::green_geometric);
  formulation["full"] = cable.at("quadrature") == word(QuadratureRule::full);
  formulation["dynamic"] = method.dynamic;
  formulation["modal"] = method.timeless;
  formulation["static"] = !method.dynamic && !method.timeless;
  formulation["method"] = method.name;
  formulation["method_summary"] = method.summary;
  formulation["method_order"] = method.order;
  formulation["method_source"] = method.source;
  return fill_in(formulation_mustache, formulation);
}

data section_rows(const Document& document, const Pictures& pictures,
                  const std::vector<PageSection>& sections, PagePlace place) {
  data rows{data::type::list};
  for (const PageSection& section : sections) {
    if (section.place != place) continue;
    data row;
    row["id"] = section.id;
    row["link"] = section.link;
    row["heading"] = section.title;
    row["html"] = section.html(document.at(section.key), pictures.of(section.figures_key));
    rows.push_back(row);
  }
  return rows;
}

/// What the page rests on, as the list at the end of a paper, each once.
data source_rows(const Document& document) {
  std::vector<std::string> sources;
  const auto add = [&](const std::string& source) {
    if (!source.empty() && std::find(sources.begin(), sources.end(), source) == sources.end())
      sources.push_back(source);
  };
  for (const Document& reference : document.at("references"))
    add(fmt::format("{} ({}): {}", text_of(reference, "title"), text_of(reference, "name"),
                    text_of(reference, "source")));
  if (!document.contains("computed_by")) {
    const MethodInfo& method = method_of(document.at("case"));
    add(fmt::format("Of the method {}: {}", method.name, method.source));
  }
  if (document.contains("uncertainty"))
    add("Of the uncertainties: " + text_of(document.at("uncertainty"), "standard"));
  data rows{data::type::list};
  for (const std::string& source : sources) rows.push_back(data{"source", source});
  return rows;
}

}  // namespace

std::string to_page(const Document& document, const Pictures& pictures,
                    std::span<const PageSection> known_sections) {
  std::vector<PageSection> sections;
  std::string css;
  std::vector<std::string> clauses;
  for (const PageSection& section : known_sections) {
    if (!document.contains(section.key)) continue;
    sections.push_back(section);
    css += section.css;
    if (section.clause) clauses.push_back(section.clause(document));
  }
  const auto text = [&](const char* key) { return document.at(key).get<std::string>(); };
  const Document &the_case = document.at("case"), &solve = document.at("solve"),
                 &energy = document.at("energy");
  const std::vector<Verdict> verdicts = verdicts_of(document);
  const bool solved = document.at("complete").get<bool>();
  const bool given = document.contains("computed_by");
  const bool dynamic = given || method_of(the_case).dynamic;
  const std::string outcome = solve.at("outcome").get<std::string>();

  data page;
  const bool modal = !given && method_of(the_case).timeless;
  page["dynamic"] = dynamic;
  page["modal"] = modal;
  page["static"] = !dynamic && !modal;
  page["stability"] =
      std::none_of(the_case.at("load").begin(), the_case.at("load").end(), [](const Document& load) {
        return load.at("follows").get<bool>() || load.at("kind") == word(LoadKind::moment);
      });
  page["title"] = text("title");
  const Conclusion conclusion = conclusion_of(document, clauses);
  page["good"] = conclusion.good;
  page["sentence"] = conclusion.sentence;
  page["details"] = conclusion.details;
  page["has_details"] = !conclusion.details.empty();
  page["trouble"] = conclusion.trouble;
  page["help"] = conclusion.help;
  page["has_help"] = !conclusion.help.empty();
  page["first_failure"] = first_failure_html(document, pictures);
  page["solved"] = solved;
  page["ended_early"] =
      solved  ? std::string()
      : modal ? fmt::format("The run failed ({}): what is shown is how, and no result of the case.", outcome)
              : fmt::format(
                    "Only the {:.4g} s of {:.4g} s before the run ended ({}): what is "
                    "shown is how it failed, no result of the case.",
                    solve.at("end_time").get<double>(), the_case.at("time").at("end").get<double>(), outcome);
  page["has_verdicts"] = !verdicts.empty();
  page["verdicts"] = verdict_groups(verdicts, command_of(document));
  page["has_errors"] = !document.at("errors").empty();
  page["errors"] = error_rows(document);
  page["has_references"] = !document.at("references").empty();
  page["references"] = reference_rows(document);
  page.set("marks", verdict_marks(verdicts));
  // The first ones are those that the case asks for.
  constexpr std::size_t most_lead_figures = 2;
  data lead{data::type::list}, more{data::type::list};
  for (std::size_t k = 0; k < pictures.figures.size(); ++k)
    (k < most_lead_figures ? lead : more)
        .push_back(data{"html", fill_in(figure_mustache, picture_values(pictures.figures[k]))});
  page["has_more_figures"] = more.is_non_empty_list();
  page.set("lead_figures", lead);
  page.set("figures", more);
  page["animation"] = data_uri(pictures.page_animation);
  page["still"] = data_uri(pictures.page_still);
  page["animation_width"] = std::to_string(pictures.page_animation_width);
  page["animation_height"] = std::to_string(pictures.page_animation_height);
  page["frames"] = counted(pictures.frames, "frame", "frames");
  page["frame_rate"] = four_digits(pictures.frame_rate);
  page["end_time"] = four_digits(solve.at("end_time"));
  page["given"] = given;
  page["computed_by"] = given ? text("computed_by") : std::string();
  page["reported"] = document.value("reported", "Plumb");
  page["animated"] = pictures.animated();
  data notes{data::type::list};
  for (const std::string& note : pictures.animation_notes) notes.push_back(data{"note", note});
  page.set("animation_notes", notes);
  page["has_given_runs"] = document.contains("given_runs");
  if (document.contains("given_runs")) page["given_runs"] = given_runs_html(document);
  if (!energy.is_null()) {
    page["first_kinetic"] =
        energy.at("kinetic").empty() ? "not run" : four_digits(energy.at("kinetic").front());
    if (dynamic) page["drift"] = four_digits(energy.at("drift"));
    page["drift_in_words"] = energy.at("drift_in_words").get<std::string>();
  }
  page["cost"] = cost_rows(document);
  page["formulation"] = formulation_html(document);
  page["case_rows"] = case_rows(document);
  set_case_and_provenance(page, document);
  page.set("of_comparisons", section_rows(document, pictures, sections, PagePlace::comparisons));
  page.set("of_cost", section_rows(document, pictures, sections, PagePlace::cost));
  page.set("sources", source_rows(document));
  const std::string changes = changes_html(document);
  page["has_changes"] = !changes.empty();
  page["changes"] = changes;
  const std::string title = text("title") + " – Plumb report";
  return html_page(conclusion.good ? title : text("outcome") + ": " + title, css,
                   fill_in(page_mustache, page), page_scripts(sections), page_data(document, sections));
}

void write_report(const Document& document, const Pictures& pictures, std::span<const PageSection> sections,
                  OutputFolder& folder) {
  folder.write("index.html", to_page(document, pictures, sections));
  write_formats(content_of(document), folder);
}

}  // namespace plumb
