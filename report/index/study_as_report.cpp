#include "report/index/study_as_report.h"

#include <algorithm>
#include <array>

namespace plumb {

Document study_as_report(const Document& study, const std::vector<std::string>& pictures) {
  static constexpr std::array common{"schema_version",   "title",      "headline",
                                     "all_criteria_met", "verdicts",   "case",
                                     "seconds",          "provenance", "check_sum"};
  Document report;
  for (const char* key : {"title", "headline", "all_criteria_met", "verdicts", "case"})
    report[key] = study.at(key);
  for (const char* key : common)
    if (study.contains(key)) report[key] = study.at(key);
  report[study_results_key] = Document::object();
  for (const auto& [key, value] : study.items())
    if (std::find(common.begin(), common.end(), key) == common.end()) report[study_results_key][key] = value;
  report["is_study"] = true;
  report["complete"] = true;
  report["outcome"] = "completed";
  report["outcome_reason"] = study.at("headline");
  report["reported"] = "Plumb";
  report["solve"] = {{"method", ""}, {"elements", -1}, {"solve_seconds", -1}};
  report["errors"] = report["references"] = Document::array();
  report["energy"] = nullptr;
  report["probes"] = Document::object();
  report["animation"] = {{"frames", 0}};
  report[figures_key] = Document::array();
  for (const std::string& file : pictures) {
    std::string title = file.substr(file.rfind('/') + 1);
    title.resize(title.rfind('.'));
    std::replace(title.begin(), title.end(), '_', ' ');
    report[figures_key].push_back({{"file", file}, {"title", title}});
  }
  return report;
}

}  // namespace plumb
