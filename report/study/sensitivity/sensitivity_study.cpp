#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/study/sensitivity/sensitivity_json.h"
#include "report/study/made_study.h"
#include "report/study/sensitivity/sensitivity_figure.h"
#include "report/study/sensitivity/sensitivity_results.h"
#include "report/study/sensitivity/sensitivity_section.h"

namespace plumb {

extern const std::string_view sensitivity_schema_json;

namespace {

class MadeSensitivity : public MadeStudy {
 public:
  explicit MadeSensitivity(SensitivityStudy study) : study_(std::move(study)) {}

  std::string title() const override { return study_.loaded.spec.title; }
  std::pair<std::string, std::string> file() const override {
    return {study_json_name, encode_sensitivity(study_)};
  }
  std::vector<Figure> figures() const override {
    const Sensitivity& found = study_.result;
    if (!found.left_out.empty() || found.numbers.empty()) return {};
    return {sensitivity_figure(found)};
  }
  StudyReport report(const Stages& stages) const override { return evaluate_sensitivity(study_, stages); }
  StudySection section(const std::vector<Picture>& pictures) const override {
    const PageSection shown = sensitivity_on_page();
    return {.links = {{shown.id, shown.link}},
            .html = fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", shown.id, shown.title,
                                shown.html(sensitivity_document(study_.result), pictures)),
            .verdict_note = "All are <strong>verification</strong>: of what the criteria are worth."};
  }
  std::vector<Finding> findings() const override {
    std::vector<Finding> lines;
    for (std::size_t k = 0; k < study_.result.criteria.size(); ++k)
      lines.push_back({noticed_in_words(study_.result, k)});
    return lines;
  }

 private:
  SensitivityStudy study_;
};

}  // namespace

StudyKind sensitivity_study() {
  return {"sensitivity",
          "_sensitivity",
          [](const Case& spec) { return spec.sensitivity.has_value(); },
          false,
          sensitivity_parts,
          sensitivity_schema_json,
          [](const LoadedCase& loaded, Runner& runner) -> std::unique_ptr<MadeStudy> {
            if (loaded.spec.references.empty() && loaded.spec.given_runs.empty())
              throw InputError(loaded.source.file.name + ": has no criterion that could notice anything");
            Sensitivity found = run_sensitivity(loaded, judged_criteria, runner);
            return std::make_unique<MadeSensitivity>(
                SensitivityStudy{loaded, std::move(found), runner.provenance()});
          },
          [](const std::string& json, const std::string& file) -> std::unique_ptr<MadeStudy> {
            return std::make_unique<MadeSensitivity>(decode_sensitivity(json, file));
          },
          true};
}

}  // namespace plumb
