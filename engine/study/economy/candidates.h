#pragma once

#include <string>
#include <vector>

#include "engine/study/economy/economy.h"

namespace plumb {

/// Times between the outputs that a scene needs, s: those of its frames, and so close that the outputs which
/// the case asks for are among them if it has references or figures that need them.
double scene_output_interval(const Case& spec);

/// Outputs of a candidate from frame to frame: between frames it is held against others as well.
inline constexpr int outputs_of_a_frame = 4;

/// The case with the model and method of a candidate, and outputs where frames are and between them.
Case with_candidate(const Case& spec, const Candidate& candidate);
/// What makes the case of the file that one, as --set takes it.
std::vector<std::string> candidate_overrides(const Case& spec, const Candidate& candidate);

/// "cable of 8 elements, velocity-verlet with step 0.00025 s".
std::string in_words(const Candidate& candidate);

/// True of the leapfrog's steps, usual_explicit().
bool is_leapfrog(const Candidate& candidate);

/// The full model on a mesh by the leapfrog, at a share of the step that it is stable up to.
Candidate cable_candidate(const Case& spec, int elements, double share_of_step = 1);

/// Everything that could be cheaper than `limit` (predicted work, ns), from cheap to dear: the rigid rod
/// where there is one, chains, cables with fewer elements, without bending, with reduced quadrature, with
/// shorter steps than they need to be stable, and with long implicit steps.
std::vector<Candidate> all_candidates(const Case& spec, double limit);

/// The safe default: 64 elements, embedded_explicit() with rtol and atol of 1e-8. Its work is not known.
Candidate safe_candidate(const Case& spec);
/// Its predicted work, ns: it takes its first thousands of steps to tell, and counts as many a second to the
/// end; the same on every machine.
double safe_work(const Case& spec);

}  // namespace plumb
