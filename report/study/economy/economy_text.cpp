#include "report/study/economy/economy_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/study/economy/candidates.h"

namespace plumb {
namespace {

/// The full model on the case's own mesh.
const TriedCandidate* own_mesh(const Economy& economy) {
  const auto found =
      std::find_if(economy.tried.begin(), economy.tried.end(), [&](const TriedCandidate& tried) {
        return tried.candidate.cable.model == CableModel::cable && tried.estimate >= 0 &&
               tried.candidate.cable.elements == economy.case_elements && is_leapfrog(tried.candidate);
      });
  return found == economy.tried.end() ? nullptr : &*found;
}

/// "a cable of 16 elements", without its method.
std::string model_in_words(const TriedCandidate& tried) {
  const std::string all = in_words(tried.candidate);
  return "a " + all.substr(0, all.find(", " + tried.candidate.method.name));
}

}  // namespace

std::string seconds_in_words(double seconds) {
  if (seconds < 0) return "not run";
  return seconds < 1e-3 ? fmt::format("{:.3g} µs", 1e6 * seconds)
         : seconds < 1  ? fmt::format("{:.3g} ms", 1e3 * seconds)
                        : fmt::format("{:.3g} s", seconds);
}

std::string pixels_in_words(double pixels) {
  if (pixels < 0) return "not known";
  return std::isfinite(pixels) ? fmt::format("{:.2g} px", pixels) : "more than can be told";
}

std::string economy_sentence(const Economy& economy, const SceneSpec& scene) {
  const TriedCandidate* choice = economy.choice();
  const std::string where = fmt::format("At {} by {} pixels", scene.size[0], scene.size[1]);
  if (!economy.holds || choice == nullptr)
    return fmt::format("{} no candidate is known to be within {:g} px of the true picture. Uncertain is {}.",
                       where, economy.tolerance, economy.uncertain);
  std::string text = fmt::format("{} this scene needs {}, off by {} as estimated", where,
                                 model_in_words(*choice), pixels_in_words(choice->estimate));
  if (choice->true_error >= 0) text += fmt::format(" and {} in truth", pixels_in_words(choice->true_error));
  if (const TriedCandidate* own = own_mesh(economy)) {
    text +=
        own->candidate.cable == choice->candidate.cable
            ? "; that is the mesh of the case"
            : fmt::format("; the {} of the case {} off by {}",
                          own->candidate.cable.elements == 1
                              ? std::string("one element")
                              : fmt::format("{} elements", own->candidate.cable.elements),
                          own->candidate.cable.elements == 1 ? "is" : "are", pixels_in_words(own->estimate));
  }
  return text + fmt::format(" (tolerance {:g} px).", economy.tolerance);
}

std::vector<std::string> explain(const Economy& economy) {
  std::vector<std::string> lines;
  std::size_t width = 0;
  for (const TriedCandidate& tried : economy.tried) width = std::max(width, in_words(tried.candidate).size());
  for (std::size_t k = 0; k < economy.tried.size(); ++k) {
    const TriedCandidate& tried = economy.tried[k];
    std::string line =
        fmt::format("{} {:<{}}  {:>8}  {:>21}", static_cast<int>(k) == economy.chosen ? ">" : " ",
                    in_words(tried.candidate), width, seconds_in_words(tried.seconds),
                    tried.estimate < 0 ? "–" : pixels_in_words(tried.estimate));
    if (tried.true_error >= 0) line += fmt::format("  in truth {}", pixels_in_words(tried.true_error));
    lines.push_back(line + "  " + tried.why);
  }
  if (!economy.finest.empty())
    lines.push_back(
        fmt::format("estimates are distances to the finest run ({}), and its own error, {}; errors of "
                    "the full model fall by {:.2g} from mesh to mesh",
                    economy.finest, pixels_in_words(economy.finest_error), economy.observed_ratio));
  if (economy.time_share >= 0)
    lines.push_back(
        fmt::format("of the chosen candidate's error its step is guilty of {}, model and mesh of the rest",
                    pixels_in_words(economy.time_share)));
  lines.push_back(
      fmt::format("the search took {}, {:.2g} of the predicted cost of one run at the safe default",
                  seconds_in_words(economy.search_seconds), economy.search_work / economy.safe_work));
  return lines;
}

Verdict verdict_without_choice(double tolerance) {
  Economy nothing;
  nothing.tolerance = tolerance;
  Verdict verdict = economy_verdict(nothing);
  verdict.detail = verdict.message =
      "the run was left to its scene, and what that needs is not at hand: choice.json is missing, or of "
      "another "
      "run or version";
  return verdict;
}

Verdict economy_verdict(const Economy& economy) {
  Verdict verdict;
  verdict.kind = VerdictKind::verification;
  verdict.name = "picture error";
  verdict.criterion =
      fmt::format("{:g} × estimated distance on the picture ≤ {:g} px", economy_safety, economy.tolerance);
  verdict.limit = economy.tolerance;
  verdict.unit = "px";
  verdict.reason = "What a viewer can tell is scene.tolerance; the factor is for what an estimate may miss.";
  const TriedCandidate* choice = economy.choice();
  if (choice == nullptr || !(choice->estimate >= 0)) {
    verdict.detail = verdict.message = "its error could not be estimated: uncertain is " + economy.uncertain;
    return verdict;
  }
  verdict.value = economy_safety * choice->estimate;
  // An earlier search that was kept may say what its own numbers do not.
  const bool holds = economy.holds && within(verdict.value, verdict.limit);
  verdict.status = holds ? VerdictStatus::passed : VerdictStatus::failed;
  verdict.detail =
      holds || economy.uncertain.empty() ? "over all frames" : "uncertain is " + economy.uncertain;
  verdict.message = fmt::format("{} {}", pixels_in_words(verdict.value), verdict.detail);
  return verdict;
}

}  // namespace plumb
