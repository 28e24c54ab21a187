#pragma once

#include <string>
#include <vector>

#include "engine/study/economy/economy_study.h"
#include "report/base/stages.h"
#include "report/figure/pictures.h"
#include "report/verdict/verdict.h"

namespace plumb {

/// Everything the report of an economy study says, apart from how it looks.
struct EconomyResults {
  const EconomyStudy& study;
  std::vector<Verdict> verdicts;
  Stages stages;  ///< those before the report itself
};

/// Of each picture: the true error is within the tolerance, no estimate is below the truth by more than the
/// safety factor (verification), and where it is no wider than 320 pixels the chosen rung costs at most a
/// twentieth of the safe default (performance). Of the random scenes: at least 99 % of the choices that are
/// said to hold do.
EconomyResults evaluate_economy(const EconomyStudy& study, const Stages& stages);

/// The study in one sentence.
std::string headline(const EconomyResults& results);

/// How many times the safe default costs what the chosen rung does; a lower bound where the safe default ran
/// out of time. -1: not known.
double cost_ratio(const EconomyStudy& study, const SceneNeed& need);

/// "plumb run CASE --economy --explain --set …", which repeats a random scene.
std::string command_of(const EconomyStudy& study, const RandomScene& scene);

/// What each picture needs, a line each, for a terminal.
std::vector<std::string> need_lines(const EconomyStudy& study);

/// Draws picture error against cost of each picture: figures/*.png. Throws OutputError, Interrupted.
std::vector<Picture> draw_economy(const EconomyStudy& study, OutputFolder& folder);

/// results.json, junit.xml, summary.md and index.html of an economy study.
std::string to_json(const EconomyResults& results);
std::string to_junit(const EconomyResults& results);
std::string to_summary(const EconomyResults& results);
std::string to_economy_page(const EconomyResults& results, const std::vector<Picture>& pictures);

}  // namespace plumb
