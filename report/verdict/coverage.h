#pragma once

#include <string>
#include <vector>

#include "engine/case/report_specs.h"
#include "engine/run/sampled_run.h"

namespace plumb {

/// Over how much of what it claims a comparison was made.
struct Coverage {
  std::size_t demanded = 0;        ///< times that the case asks for
  std::size_t compared = 0;        ///< of them, those at which there is something to compare
  std::size_t interpolated = 0;    ///< of the compared ones, those between two outputs of a run
  double first = 0;                ///< s, of the compared times; 0 where there is none
  double last = 0;                 ///< s, likewise
  double longest_gap = 0;          ///< s, between two outputs of a run from `first` to `last`
  double interpolation_error = 0;  ///< the greatest at a compared time, in the unit of what is compared
  bool of_modes = false;           ///< what are called times are numbers of modes
  double share = 1;                ///< of `demanded` that must be compared, in (0, 1]
  std::string allowance;           ///< how the case claims less than everything, in words; empty: it does not
  std::string lacking;             ///< why it is too little to judge by; empty: it is enough

  bool enough() const { return lacking.empty(); }
};

/// A run in a comparison, as it was sampled at the times that are asked for.
struct ComparedRun {
  std::string name;                    ///< "Plumb"
  const std::vector<double>& outputs;  ///< s
  const SampledRun& sampled;
};

/// What a comparison asks for.
struct Demand {
  std::vector<double> times;  ///< s, all of them
  CoverageSpec claimed;
  std::string of;         ///< whose times they are: "the reference"
  std::string column;     ///< that is compared
  std::string unit;       ///< of the column
  double tolerance = 0;   ///< in `unit`; infinity: none, so that no interpolation error is too great
  bool of_modes = false;  ///< what are called times are numbers of modes

  /// Those of `times` within what the case claims: what runs are to be sampled at.
  std::vector<double> claimed_times() const;
};

/// Which of the claimed times can be compared, and whether they are enough: of what is asked for, with one at
/// least after t = 0. A time can be where every run has it as an output, or is interpolated there with an
/// error that can be told and is bearable.
struct Covered {
  Coverage coverage;
  std::vector<std::size_t> times;              ///< places among the claimed ones, rising
  std::vector<std::vector<std::size_t>> rows;  ///< of each run's sample, as many as `times`
};

Covered cover(const Demand& demand, const std::vector<ComparedRun>& runs);

/// "over 3 of 4 times from 0 to 1 s", with what else must be known of them to judge what was found.
std::string in_words(const Coverage& coverage, const std::string& unit);

}  // namespace plumb
