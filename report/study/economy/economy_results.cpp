#include "report/study/economy/economy_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/study/economy/candidates.h"
#include "engine/study/economy/economy_json.h"
#include "engine/study/economy/economy_study_json.h"
#include "report/base/escape.h"
#include "report/study/economy/economy_text.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

constexpr int narrow = 320;         // pixels, where the scene must cost
constexpr double least_ratio = 20;  // times less than the safe default
constexpr double least_share = 0.99;

Verdict verdict_of(VerdictKind kind, const std::string& name, const std::string& criterion, double value,
                   double limit, const std::string& unit, bool passed, const std::string& message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.name = name;
  verdict.criterion = criterion;
  verdict.value = value;
  verdict.limit = limit;
  verdict.unit = unit;
  verdict.status = passed ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail = verdict.message = message;
  return verdict;
}

void judge_need(const EconomyStudy& study, const SceneNeed& need, std::vector<Verdict>& verdicts) {
  const Economy& economy = need.economy;
  const TriedCandidate* choice = economy.choice();
  const bool known = choice != nullptr && choice->true_error >= 0 && need.certified &&
                     need.reference_doubt >= 0 && std::isfinite(need.reference_doubt);
  Verdict truth = verdict_of(
      VerdictKind::verification, need.name + ": truth",
      fmt::format("true distance on the picture ≤ {:g} px", economy.tolerance),
      known ? choice->true_error : -1, economy.tolerance, "px",
      known && within(choice->true_error, economy.tolerance),
      known ? fmt::format("{} by {}, estimated {}", pixels_in_words(choice->true_error),
                          in_words(choice->candidate), pixels_in_words(choice->estimate))
            : fmt::format("the reference may be off by {}", pixels_in_words(need.reference_doubt)));
  if (!known) truth.status = VerdictStatus::not_run;
  verdicts.push_back(std::move(truth));
  const double worst = need.worst_ratio();
  Verdict estimates = verdict_of(
      VerdictKind::verification, need.name + ": estimates",
      fmt::format("true error ≤ {:g} × its estimate, beyond the doubt of the reference", economy_safety),
      worst, economy_safety, "1", worst <= economy_safety,
      fmt::format("{:.2f} at most, over {}", worst,
                  counted(need.proven_candidates(), "candidate", "candidates")));
  if (need.proven_candidates() == 0) {
    estimates.status = VerdictStatus::not_run;
    estimates.value = -1;
    estimates.detail = estimates.message = "no candidate has both an estimate and a true error";
  }
  verdicts.push_back(std::move(estimates));
  if (need.scene.size[0] > narrow) return;
  const double ratio = cost_ratio(study, need);
  Verdict cost = verdict_of(VerdictKind::performance, need.name + ": cost",
                            fmt::format("safe default costs ≥ {:g} times as much", least_ratio), ratio,
                            least_ratio, "1", ratio >= least_ratio,
                            fmt::format("{:.0f} times: {:.3g} ms instead of {:.3g} s", ratio,
                                        1e3 * need.seconds, study.safe_seconds));
  if (ratio < 0) {
    cost.status = VerdictStatus::not_run;
    cost.detail = cost.message = "what it costs was not measured";
  }
  verdicts.push_back(std::move(cost));
}

struct Counts {
  long hold = 0;
  long missed = 0;
};

Counts counts_of(const EconomyStudy& study) {
  Counts counts;
  for (const RandomScene& scene : study.scenes) {
    if (scene.holds) ++counts.hold;
    if (scene.missed()) ++counts.missed;
  }
  return counts;
}

/// The picture that the case itself asks for, if it was among them, or the first.
const SceneNeed* own_picture(const EconomyStudy& study) {
  const auto own = std::find_if(study.needs.begin(), study.needs.end(), [&](const SceneNeed& need) {
    return need.scene.size == study.loaded.spec.scene.size;
  });
  if (own != study.needs.end()) return &*own;
  return study.needs.empty() ? nullptr : &study.needs.front();
}

double met_share(const Counts& counts) {
  return counts.hold > 0 ? 1 - static_cast<double>(counts.missed) / static_cast<double>(counts.hold) : 0;
}

std::vector<Verdict> verdicts_of(const EconomyStudy& study) {
  std::vector<Verdict> verdicts;
  for (const SceneNeed& need : study.needs) judge_need(study, need, verdicts);
  if (study.scenes.empty()) return verdicts;
  const Counts counts = counts_of(study);
  const double share = met_share(counts);
  Verdict scenes = verdict_of(
      VerdictKind::verification, "random scenes",
      fmt::format("true error ≤ tolerance in ≥ {:g} % of the scenes where a candidate is said to hold",
                  100 * least_share),
      100 * share, 100 * least_share, "%", share >= least_share,
      fmt::format("{:.1f} %: {} of {} missed; in {} no candidate is said to hold", 100 * share, counts.missed,
                  counts.hold, std::ssize(study.scenes) - counts.hold));
  if (counts.hold == 0) {
    scenes.status = VerdictStatus::not_run;
    scenes.value = -1;
    scenes.detail = scenes.message = "in none of the scenes a candidate is said to hold";
  }
  verdicts.push_back(std::move(scenes));
  return verdicts;
}

Document study_document(const EconomyStudy& study) {
  Document economy{{"reference", study.reference},
                   {"safe_seconds", study.safe_seconds},
                   {"safe_end", study.safe_end},
                   {"pictures", Document::array()},
                   {"random_scenes", Document::array()}};
  for (const SceneNeed& need : study.needs) {
    Document item{{"name", need.name},
                  {"in_words", economy_sentence(need.economy, need.scene)},
                  {"seconds", need.seconds},
                  {"cost_ratio", cost_ratio(study, need)},
                  {"reference_doubt", need.reference_doubt},
                  {"certified", need.certified}};
    item.update(to_stored(need.economy));
    economy["pictures"].push_back(std::move(item));
  }
  for (const RandomScene& scene : study.scenes) economy["random_scenes"].push_back(random_scene_json(scene));
  return economy;
}

}  // namespace

double cost_ratio(const EconomyStudy& study, const SceneNeed& need) {
  if (!(need.seconds > 0) || !(study.safe_seconds > 0)) return -1;
  if (!std::isfinite(need.seconds) || !std::isfinite(study.safe_seconds)) return -1;
  return study.safe_seconds / need.seconds;
}

std::string command_of(const EconomyStudy& study, const RandomScene& scene) {
  std::string command = "plumb run " + study.loaded.source.file.name + " --economy --explain";
  for (const std::string& text : study.loaded.source.overrides) command += " --set '" + text + "'";
  for (const std::string& text : scene.overrides) command += " --set '" + text + "'";
  return command;
}

std::vector<std::string> need_lines(const EconomyStudy& study) {
  std::vector<std::string> lines;
  for (const SceneNeed& need : study.needs) {
    const TriedCandidate* choice = need.economy.choice();
    if (choice == nullptr) continue;
    lines.push_back(
        fmt::format("  {}: {}{}; estimated {}, in truth {}, tolerance {:g} px; {:.3g} ms, {:.0f} times "
                    "less than the safe default",
                    need.name, in_words(choice->candidate), need.economy.holds ? "" : " (unproven)",
                    pixels_in_words(choice->estimate), pixels_in_words(choice->true_error),
                    need.economy.tolerance, 1e3 * need.seconds, cost_ratio(study, need)));
  }
  for (const RandomScene& scene : study.scenes)
    if (scene.missed())
      lines.push_back(fmt::format("  scene {}: {} is {} off, tolerance {:g} px: {}", scene.number,
                                  scene.chosen, pixels_in_words(scene.true_error), scene.tolerance,
                                  command_of(study, scene)));
  return lines;
}

StudyReport evaluate_economy(const EconomyStudy& study, const Stages& stages) {
  StudyReport report{study.loaded, "what scenes need", study.provenance, verdicts_of(study), stages};
  const SceneNeed* own = own_picture(study);
  report.headline = own == nullptr ? "No picture was asked for, so nothing can be said of what it needs."
                                   : economy_sentence(own->economy, own->scene);
  if (own != nullptr && cost_ratio(study, *own) > 0)
    report.details = fmt::format("That costs {}, where the safe default takes {}.",
                                 seconds_in_words(own->seconds), seconds_in_words(study.safe_seconds));
  if (!study.scenes.empty()) {
    const Counts counts = counts_of(study);
    const std::string scenes = counted(std::ssize(study.scenes), "random scene", "random scenes");
    report.details += report.details.empty() ? "" : " ";
    report.details +=
        counts.missed == 0 && counts.hold == std::ssize(study.scenes)
            ? fmt::format("The choice for each of {} met its tolerance.", scenes)
            : fmt::format("Of {}, {} met the tolerance that the choice was said to meet, {} did not.", scenes,
                          counts.hold - counts.missed, counts.missed);
  }
  report.counts = met_in_words(report.verdicts);
  report.results["economy"] = study_document(study);
  for (const std::string& line : need_lines(study)) report.after += "\n-" + escape_markdown(line.substr(1));
  report.after += "\n";
  return report;
}

}  // namespace plumb
