#include "report/program/verbs.h"

#include <vector>

namespace plumb {

std::span<const Verb> verbs() {
  static const std::vector<Verb> all{
      {.name = "run",
       .summary = "the whole way: solve, draw, compare, report",
       .act = run_verb,
       .input = "CASE",
       .takes_many = true,
       .takes_baseline = true,
       .takes_overrides = true,
       .takes_output = true,
       .chooses = true},
      {.name = "solve",
       .summary = "integrate only: run.h5 and probes.csv",
       .act = solve_verb,
       .input = "CASE",
       .takes_overrides = true,
       .takes_output = true,
       .takes_csv = true,
       .chooses = true},
      {.name = "render",
       .summary = "frames, figures and animation from a finished run",
       .act = render_verb,
       .input = "RUN",
       .takes_overrides = true,
       .takes_output = true,
       .draws = true},
      {.name = "report",
       .summary = "the report, with its pictures, from a finished run; of several runs, an index",
       .act = report_verb,
       .input = "RUN",
       .takes_many = true,
       .takes_document = true,
       .takes_output = true},
      {.name = "study",
       .summary = "vary a case: work against precision, where methods fail",
       .act = study_verb,
       .input = "CASE",
       .takes_overrides = true,
       .takes_output = true,
       .takes_kind = true},
      {.name = "check",
       .summary = "say whether a case is valid, without running it",
       .act = check_verb,
       .input = "CASE",
       .takes_overrides = true},
      {.name = "diff",
       .summary = "compare two pictures, two files of numbers, or two output folders",
       .act = diff_verb,
       .input = "A",
       .compares = true},
      {.name = "doctor",
       .summary = "what was found on this machine: renderer, libraries, methods",
       .act = doctor_verb}};
  return all;
}

}  // namespace plumb
