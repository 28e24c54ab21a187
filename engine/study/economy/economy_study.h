#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/provenance.h"
#include "engine/study/economy/economy.h"

namespace plumb {

/// One picture of a case, what it needs, and how far that is from the truth.
struct SceneNeed {
  std::string name;  ///< "320 by 180, camera of the scene"
  SceneSpec scene;
  Economy economy;              ///< with the true errors of all that was tried
  double seconds = -1;          ///< of the chosen candidate's time loop, the least of three
  double reference_doubt = -1;  ///< what the reference may be off by, pixels
  bool certified = false;       ///< that is at most a tenth of the tolerance

  /// Greatest ratio of a true error, less what the reference may be off by, to its estimate, over all that
  /// was tried and has both.
  double worst_ratio() const;
  /// Over how many that is; 0 where what the reference may be off by is not known.
  long proven_candidates() const;
};

/// A random scene and what became of it.
struct RandomScene {
  long number = 0;                     ///< scene k of the seed
  std::vector<std::string> overrides;  ///< what makes it of the file's case, as --set takes them
  std::string chosen;                  ///< in words
  double tolerance = 0;                ///< pixels
  bool holds = false;                  ///< the search says so
  double estimate = -1;                ///< pixels
  double true_error = -1;              ///< pixels
  double reference_doubt = -1;         ///< pixels
  double seconds = -1;                 ///< of the chosen candidate
  double search_share = -1;            ///< of the predicted cost of one run at the safe default
  std::string uncertain;               ///< where it does not hold

  /// The search says that it holds, and it does not, or nothing shows that it does.
  bool missed() const {
    const bool known = reference_doubt >= 0 && std::isfinite(reference_doubt) && true_error >= 0;
    return holds && !(known && true_error <= tolerance);
  }
};

/// What scenes of one case need, each proven by a reference, and random ones.
struct EconomyStudy {
  LoadedCase loaded;
  EconomySpec spec;
  std::string reference;     ///< in words
  double safe_seconds = -1;  ///< of one run at the safe default
  double safe_end = -1;      ///< s, that it reached in the time allowed
  std::vector<SceneNeed> needs;
  std::vector<RandomScene> scenes;
  Provenance provenance;
};

}  // namespace plumb
