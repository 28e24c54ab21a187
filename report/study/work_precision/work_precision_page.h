#pragma once

#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision.h"
#include "report/study/study_report.h"

namespace plumb {

/// The quick study of a case as a section of the report of its run.
RunSection work_precision_section(const WorkPrecision& study);

/// How a page shows it: charts, tables, failures and certificates. Where scripts run, the charts take the
/// place of the pictures.
PageSection work_precision_on_page();

/// What the distance between the meshes of the study in a document says of the mesh of its run:
/// "; the mesh itself is …"; empty for nothing.
std::string mesh_clause(const Document& document);

/// A whole study on its own page. `pictures` are those of study_figures.
StudySection shown_work_precision(const WorkPrecision& study, const std::vector<Picture>& pictures);

}  // namespace plumb
