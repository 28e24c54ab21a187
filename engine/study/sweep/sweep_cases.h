#pragma once

#include <string>
#include <vector>

#include "engine/case/case_source.h"

namespace plumb {

/// Cases of one model follow each other, so that they can share its references: cases k with the same
/// k / runs_of_a_model differ in method, step and tolerances only.
inline constexpr long runs_of_a_model = 8;

/// What makes random model m of a file's case, as --set takes it; it depends on the seed and m alone:
/// elements (1 to 16), every pair of supports, strain model, quadrature, slope rates, the end (0.05 to 0.5 s,
/// with 20 outputs), and the parameter f (1 to 20, of equal ratio) if the case has it. Each in one of three
/// models, where the file has none itself: loads of up to three weights, and moments of up to some EI/L, that
/// change or follow or do not; a mass; damping; supports that move.
std::vector<std::string> model_overrides(const Case& file_case, long seed, long model);

/// What makes case k of its model: a method that takes the model, with a step from far below the explicit
/// limit up to the end, or with tolerances from 1e-11 to 0.3, and in one of two cases other values of its own
/// parameters. A method that is the file's own keeps to a step or to tolerances as the file does.
std::vector<std::string> method_overrides(const Case& file_case, const Case& model, long seed, long number);

}  // namespace plumb
