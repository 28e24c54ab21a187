#pragma once

#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision.h"
#include "report/figure/pictures.h"
#include "report/study/work_precision/work_precision_results.h"

namespace plumb {

/// A study as a part of a page: charts, tables, failures and certificates. `pictures` are those of
/// draw_study; the charts take their place where scripts run.
std::string study_section(const WorkPrecision& study, const std::vector<Picture>& pictures);

/// The scripts of the charts with their data, for the end of a page's body.
std::string study_scripts(const WorkPrecision& study);

/// The directive of a content security policy that lets just those scripts run: "script-src 'sha256-…' …".
std::string study_script_policy();

/// The page of `plumb study`: one file that opens offline.
std::string to_study_page(const StudyResults& results, const std::vector<Picture>& pictures);

}  // namespace plumb
