#include "report/page.h"

#include <fmt/format.h>

#include "engine/integrate/method_info.h"
#include "report/economy_section.h"
#include "report/page_tables.h"
#include "report/page_template.h"
#include "report/study_json.h"
#include "report/study_page.h"
#include "report/verdict_html.h"

namespace plumb {

extern const std::string_view page_mustache;
extern const std::string_view page_css;
extern const std::string_view study_css;
extern const std::string_view formulation_mustache;

namespace {

using kainjow::mustache::data;

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

/// What is not finite has no number in JSON.
std::string number(const Document& value) {
  return value.is_number() ? number(value.get<double>()) : "not finite";
}

data figure_rows(const std::vector<Picture>& pictures) {
  data rows{data::type::list};
  for (const Picture& picture : pictures) {
    data row;
    row["title"] = picture.title;
    row["alt"] = picture.alt;
    row["tall"] = picture.tall;
    row["file"] = picture.file;
    row["uri"] = data_uri(picture.png);
    rows.push_back(row);
  }
  return rows;
}

std::string formulation_html(const Document& the_case) {
  const Document& cable = the_case.at("cable");
  const MethodInfo& method = *find_method(the_case.at("method").at("name").get<std::string>());
  data formulation;
  formulation["rigid"] = cable.at("model") == word(CableModel::rigid);
  formulation["chain"] = cable.at("model") == word(CableModel::chain);
  formulation["green"] = cable.at("strain") == word(StrainModel::green_geometric);
  formulation["full"] = cable.at("quadrature") == word(QuadratureRule::full);
  formulation["dynamic"] = method.dynamic;
  formulation["method"] = method.name;
  formulation["method_summary"] = method.summary;
  formulation["method_order"] = method.order;
  formulation["method_source"] = method.source;
  return fill_in(formulation_mustache, formulation);
}

}  // namespace

std::string to_page(const Document& document, const Pictures& pictures) {
  const auto text = [&](const char* key) { return document.at(key).get<std::string>(); };
  const Document &the_case = document.at("case"), &solve = document.at("solve"),
                 &energy = document.at("energy");
  const std::vector<Verdict> verdicts = verdicts_of(document);
  const bool solved = document.at("complete").get<bool>();
  const bool dynamic = find_method(the_case.at("method").at("name").get<std::string>())->dynamic;
  const std::string outcome = solve.at("outcome").get<std::string>();

  data page;
  page["css"] = std::string(page_css) + (document.contains("work_precision") ? std::string(study_css) : "");
  page["dynamic"] = dynamic;
  page["title"] = text("title");
  page["headline"] = text("headline");
  page["good"] = document.at("all_criteria_met").get<bool>();
  page["solved"] = solved;
  page["ended_early"] =
      solved ? std::string()
             : fmt::format(
                   "Only the {:.4g} s of {:.4g} s before the run ended ({}): what is "
                   "shown is how it failed, no result of the case.",
                   solve.at("end_time").get<double>(), the_case.at("time").at("end").get<double>(), outcome);
  page["message"] = solve.at("message").get<std::string>();
  page["outcome"] = outcome;
  page["has_verdicts"] = !verdicts.empty();
  page["verdicts"] = verdict_html(verdicts);
  page["has_errors"] = !document.at("errors").empty();
  page["errors"] = error_rows(document);
  page["references"] = reference_rows(document);
  page.set("figures", figure_rows(pictures.figures));
  page["animation"] = data_uri(pictures.page_animation);
  page["still"] = data_uri(pictures.page_still);
  page["animation_width"] = std::to_string(pictures.page_animation_width);
  page["animation_height"] = std::to_string(pictures.page_animation_height);
  page["frames"] = std::to_string(pictures.frames);
  page["frame_rate"] = number(pictures.frame_rate);
  page["end_time"] = number(solve.at("end_time"));
  page["first_kinetic"] = energy.at("kinetic").empty() ? "not run" : number(energy.at("kinetic").front());
  page["drift"] = number(energy.at("drift"));
  page["drift_in_words"] = energy.at("drift_in_words").get<std::string>();
  page["cost"] = cost_rows(document);
  page["formulation"] = formulation_html(the_case);
  page["case_rows"] = case_rows(document);
  set_case_and_provenance(page, document);
  if (document.contains("economy")) page["economy"] = economy_section(document.at("economy"));
  page["has_study"] = document.contains("work_precision");
  if (document.contains("work_precision")) {
    const WorkPrecision study = work_precision_from_json(document.at("work_precision"));
    page["script_policy"] = "; " + study_script_policy();
    page["study"] = study_section(study, pictures.study);
    page["scripts"] = study_scripts(study);
  }
  return fill_in(page_mustache, page);
}

}  // namespace plumb
