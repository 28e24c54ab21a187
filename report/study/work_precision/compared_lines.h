#pragma once

#include <string>
#include <vector>

#include "engine/study/work_precision/work_precision.h"

namespace plumb {

/// The two questions of a study, which no figure and no table mixes.
enum class StudyQuestion {
  time,   ///< how well time is integrated on the mesh of the case
  total,  ///< how close to the continuum method and mesh together come
};

/// Of a run, or of a point of another program.
const ErrorNorms& errors_of(const auto& run, StudyQuestion question) {
  return question == StudyQuestion::time ? run.time_error : run.total_error;
}
/// The Pareto front of a question, indices into WorkPrecision::runs.
const std::vector<std::size_t>& front_of(const WorkPrecision& study, StudyQuestion question);
/// The reference that a question's errors are held against; nullptr: there is none.
const CertifiedReference* reference_of(const WorkPrecision& study, StudyQuestion question);

/// What became of a run, as far as it can be shown.
enum class RunFate {
  good,
  wrong,   ///< completed, but further off than `wrong_beyond` of the length
  failed,  ///< did not complete, or its error is not known
};
RunFate fate_of(const WorkPrecision& study, const WorkPrecisionRun& run, StudyQuestion question);
RunFate fate_of(const WorkPrecision& study, const GivenPoint& point, StudyQuestion question);

/// What a legend calls the curve of another program: its name, what computed it and on how many threads, and
/// that it ran on another machine or is scaled from one. No method is called so.
std::string label_of(const WorkPrecision& study, const GivenCurve& curve);
/// "this machine", "laptop", "another machine".
std::string machine_in_words(const GivenCurve& curve);

/// What a run says for itself in a table: "unstable: …", "stable but wrong: 0.51 m off"; empty for a good
/// one.
std::string trouble_of(const WorkPrecision& study, const WorkPrecisionRun& run, StudyQuestion question);

/// Whether any run has an error of the question.
bool any_compared(const WorkPrecision& study, StudyQuestion question);

/// A method with its variant and all its runs that a question is about: of one mesh, or of every mesh.
struct StudyLine {
  std::string label;
  std::string method;
  MethodFamily family = MethodFamily::explicit_one_step;
  std::vector<std::size_t> curves;  ///< indices into WorkPrecision::curves
  std::vector<std::size_t> runs;    ///< indices into WorkPrecision::runs
};

/// In the order of the study's curves.
std::vector<StudyLine> study_lines(const WorkPrecision& study, StudyQuestion question);

/// The lines that one picture has room for, at most `most` of them, in their order: the best of each family,
/// then those on the front, then the best of the rest; of one family no more than half, unless there is room.
/// Better is what has more runs on the front, and then what costs the least over the cheapest run of at most
/// the same error, at its best run.
std::vector<StudyLine> chosen_lines(const WorkPrecision& study, StudyQuestion question, std::size_t most);

}  // namespace plumb
