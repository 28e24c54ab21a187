#pragma once

#include "engine/study/economy/economy.h"

namespace plumb {

/// Finds the cheapest candidate that a scene needs. First the full model is refined, mesh and step together,
/// until the distances on the picture of three meshes in a row tell that one of them holds; then the others
/// are tried from the cheapest candidate, each held against the finest run, up to the first that holds;
/// candidates that what was run tells to be hopeless are passed over. A candidate's error is estimated as its
/// distance to the finest run and that one's own error by the observed ratio of the errors of its meshes, of
/// which no more than order 2 is believed; it holds where economy_safety times that is at most the tolerance.
///
/// No run is begun with which the search would come to cost more than one at the safe default: then that is
/// chosen. Where no candidate holds, the finest is chosen, and `uncertain` says why: the motion may be beyond
/// its predictability horizon. The choice depends on the case alone, not on how long anything took. Throws
/// InputError where the case does not move.
Economy choose_candidate(const Case& spec, const MakeGauge& make_gauge);

}  // namespace plumb
