#include "report/program/verbs.h"

#include <vector>

namespace plumb {

std::span<const Verb> verbs() {
  static const std::vector<Verb> all{
      {"run", "the whole way: solve, draw, compare, report", "CASE", true, true, false, false, run_verb},
      {"solve", "integrate only: run.h5 and probes.csv", "CASE", true, true, true, false, solve_verb},
      {"render", "frames, figures and animation from a finished run", "RUN", false, true, false, false,
       render_verb},
      {"report", "the report, with its pictures, from a finished run", "RUN", false, true, false, false,
       report_verb},
      {"study", "vary a case: work against precision, where methods fail", "CASE", true, true, false, true,
       study_verb},
      {"check", "say whether a case is valid, without running it", "CASE", true, false, false, false,
       check_verb},
      {"doctor", "what was found on this machine: renderer, libraries, methods", "", false, false, false,
       false, doctor_verb}};
  return all;
}

}  // namespace plumb
