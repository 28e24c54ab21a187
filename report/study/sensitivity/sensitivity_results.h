#pragma once

#include <string>
#include <vector>

#include "engine/study/sensitivity/run_sensitivity.h"
#include "report/base/document_value.h"
#include "report/study/study_report.h"
#include "report/verdict/run_section.h"

namespace plumb {

/// The verdicts on a run of Plumb's own, those on other programs' left out.
std::vector<JudgedCriterion> judged_criteria(const Run& run);

/// "0.035 m on published: tip.z notices 6.2 % of density, nothing of bending stiffness; …".
std::string noticed_in_words(const Sensitivity& found, std::size_t criterion);

/// "Weak: converged: tip.x notices nothing."; empty where none is weak.
std::string weak_in_words(const Sensitivity& found);

/// What results.json has of it.
Document sensitivity_document(const Sensitivity& found);

/// Two digits, and whole numbers of more.
std::string two_digits(double x);

/// A smallest change of a document as tables show it: "+6.2 %", "÷ 4", "nothing".
std::string change_text(const Document& noticed, bool up);

/// A verification for each criterion: that it is not weak.
StudyReport evaluate_sensitivity(const SensitivityStudy& study, const Stages& stages);

}  // namespace plumb
