#pragma once

#include <string>
#include <vector>

#include "engine/study/economy/economy_study.h"
#include "report/study/study_report.h"

namespace plumb {

/// Of each picture: the true error is within the tolerance, no estimate is below the truth by more than the
/// safety factor (verification), and where it is no wider than 320 pixels the chosen candidate costs at most
/// a twentieth of the safe default (performance). Of the random scenes: at least 99 % of the choices that are
/// said to hold do.
StudyReport evaluate_economy(const EconomyStudy& study, const Stages& stages);

/// Picture error against cost of each picture, and truth against estimate of the random scenes.
std::vector<Figure> economy_study_figures(const EconomyStudy& study);

/// The study on its page, with these pictures.
StudySection shown_economy(const EconomyStudy& study, const std::vector<Picture>& pictures);

/// How many times the safe default costs what the chosen candidate does; a lower bound where the safe default
/// ran out of time. -1: not known.
double cost_ratio(const EconomyStudy& study, const SceneNeed& need);

/// "plumb run CASE --economy --explain --set …", which repeats a random scene.
std::string command_of(const EconomyStudy& study, const RandomScene& scene);

/// What each picture needs, a line each, for a terminal.
std::vector<std::string> need_lines(const EconomyStudy& study);

}  // namespace plumb
