#pragma once

#include <functional>

#include "engine/study/economy/economy_study.h"
#include "engine/study/runner.h"

namespace plumb {

/// Makes the gauge of a case's scene; the engine knows no cameras.
using GaugeOfCase = std::function<MakeGauge(const Case& spec)>;

/// The economy study of a case: what its table says, or the defaults where it has none.
EconomySpec economy_study_of(const Case& spec);

/// Finds what each size of the picture needs, through the camera of the scene and the close-up, and holds it
/// and all else that was tried against a reference: the Nyström pair of order 8 on a mesh at least twice as
/// fine as any chosen. What that may be off by is told by the Gauss method of order 6, which shares nothing
/// with it but the forces, and by a mesh of half its elements. Then does the same with random scenes, where
/// half of `reference_elements` is enough and half the mesh alone tells the doubt. Throws InputError where
/// the case cannot be varied or does not move.
EconomyStudy run_economy(const LoadedCase& loaded, const GaugeOfCase& gauge_of, Runner& runner);

/// Random scene k alone.
RandomScene run_random_scene(const LoadedCase& loaded, const EconomySpec& spec, long number,
                             const GaugeOfCase& gauge_of);

}  // namespace plumb
