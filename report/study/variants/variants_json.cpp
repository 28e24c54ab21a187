#include <nlohmann/json.hpp>

#include "report/document/case_json.h"
#include "report/study/variants/variants_results.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json figure_json(const ExpectationFound& figure) {
  Json json{{"quantity", figure.expected.quantity},
            {"expected", figure.expected.value},
            {"within", figure.expected.within},
            {"found", figure.found},
            {"unit", figure.unit},
            {"met", figure.met()},
            {"source", figure.expected.source}};
  if (!figure.expected.from.empty()) json["from"] = figure.expected.from;
  return json;
}

Json variant_json(const VariantResult& variant) {
  Run run;
  run.loaded.spec = variant.run;
  run.trajectory = variant.trajectory;
  Json json{{"name", variant.spec.name},
            {"overrides", variant.spec.overrides},
            {"method", method_json(variant.run.method)},
            {"expected_outcome", variant.spec.outcome},
            {"expected_message", variant.spec.says},
            {"outcome_met", variant.outcome_met()},
            {"met", variant.met()},
            {"reason", variant.spec.reason},
            {"solve", solve_json(run)},
            {"figures", Json::array()}};
  for (const ExpectationFound& figure : variant.expectations) json["figures"].push_back(figure_json(figure));
  return json;
}

}  // namespace

std::string to_json(const VariantsResults& results) {
  Json json;
  json["schema_version"] = results_version;
  json["title"] = results.study.result.title;
  json["headline"] = headline(results);
  json["all_criteria_met"] = !results.verdicts.empty() && all_passed(results.verdicts);
  json["verdicts"] = Json::array();
  for (const Verdict& verdict : results.verdicts) json["verdicts"].push_back(verdict_json(verdict));
  json["variants"] = Json::array();
  for (const VariantResult& variant : results.study.result.variants)
    json["variants"].push_back(variant_json(variant));
  json["case"] = case_json(results.study.loaded);
  for (const auto& [name, seconds] : results.stages.all()) json["seconds"][name] = seconds;
  for (const auto& [name, value] : results.study.result.provenance) json["provenance"][name] = value;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumb
