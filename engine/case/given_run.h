#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// A column of an external run, and what it was in its file.
struct GivenColumn {
  std::string name;         ///< of the probes: "tip.x"
  std::string file_column;  ///< "X tip"
  std::string file_unit;    ///< "mm"
  std::string unit;         ///< of `values`, that of the probe
  std::vector<double> values;
};

/// How an external run ended, where its file says so, as a run file of Plumb's does.
struct GivenEnding {
  std::string outcome;  ///< the word of an outcome: "completed", "unstable"; empty: not known
  std::string message;  ///< what ended it; may be empty

  /// It is known to have failed, and so it vouches for nothing.
  bool failed() const { return !outcome.empty() && outcome != "completed"; }
  /// "unstable: the energy grew …", of one that failed.
  std::string in_words() const { return message.empty() ? outcome : outcome + ": " + message; }
};

/// A run that another program computed, as its file has it: some columns of the probes over its own times.
/// Nothing else is known of it but how it ended, where that is said: neither states nor energies.
struct GivenRun {
  std::string time_column;           ///< the file's name for the time
  std::string time_unit;             ///< in the file
  std::vector<double> times;         ///< s, strictly increasing, one or more
  std::vector<GivenColumn> columns;  ///< in the order of the probes, one or more
  GivenEnding ending;
  /// What moves in it, where the file is a run file of Plumb's own; else nothing.
  std::shared_ptr<const Case> own_case;
  std::string taken_for;           ///< what the file was taken for: "HDF5"
  std::vector<std::string> notes;  ///< how the file was read, where that is not plain
  std::vector<GivenRun> points;    ///< the runs of GivenRunSpec::points, in their order

  /// The column of that name, or nullptr.
  const GivenColumn* find(std::string_view name) const;
};

/// True where a case has no [method]: the first external run is the one that is reported.
bool reports_given_run(const Case& spec);

/// What the reported run is called: "Plumb", or the name of the first given one.
std::string reported_name(const Case& spec);

/// The first probe of the position of the last end, or nullptr.
const ProbeSpec* tip_probe(const Case& spec);

/// What computed an external run, in words: "Project Chrono 8 (chrono.csv)", or "chrono.csv".
std::string computed_by(const GivenRunSpec& spec);

}  // namespace plumb
