#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// `coverage` of a [[reference]] or a [[run]]: how much of what is compared the case claims, where that is
/// less than all of it.
struct CoverageSpec {
  std::optional<double> from;  ///< s, ≥ 0; nothing: from the first time
  std::optional<double> to;    ///< s, > `from`; nothing: to the last time
  double share = 1;            ///< of the times between, that must be compared, in (0, 1]

  /// True for a time (s) within, but for rounding.
  bool has(double t) const;

  friend bool operator==(const CoverageSpec&, const CoverageSpec&) = default;
};

/// [[run.point]]: a run by the program of a [[run]] whose time is known, beside others with another step,
/// tolerance or mesh.
struct GivenPointSpec {
  std::string label;   ///< "24 links"; default: the file's name without its ending
  std::string file;    ///< as of a [[run]], whose other keys hold for it too
  double seconds = 0;  ///< that it took, s, > 0
  std::map<std::string, std::string> columns, units;  ///< as of a [[run]], which has the defaults

  friend bool operator==(const GivenPointSpec&, const GivenPointSpec&) = default;
};

/// [[run]]: a trajectory that another program computed, reported on as one of Plumb's own.
struct GivenRunSpec {
  std::string name;     ///< unique; default: the file's name without its ending
  std::string file;     ///< CSV with a header, or HDF5; relative to the case file
  std::string program;  ///< what computed it, with its version; may be empty
  /// "t" or a column of the probes -> the file's name for it; an empty one: the file does not have it.
  std::map<std::string, std::string> columns;
  std::map<std::string, std::string> units;  ///< "t" or a column of the probes -> its unit in the file
  /// Column of the probes -> how far it may be from the run that is reported, in the column's unit, > 0.
  std::map<std::string, double> tolerances;
  CoverageSpec coverage;  ///< over how much these tolerances hold
  std::string reason;     ///< why these tolerances; may be empty
  double seconds = -1;    ///< that the run took, s, > 0; -1: not said
  int threads = 1;        ///< that it and its points ran on
  std::string machine;    ///< where they ran; empty, and without a yardstick: on this machine
  double yardstick = -1;  ///< what `plumb yardstick` gave there, s, > 0; -1: not said
  std::vector<GivenPointSpec> points;

  /// Its error is shown beside its time.
  bool is_timed() const { return seconds > 0 || !points.empty(); }

  friend bool operator==(const GivenRunSpec&, const GivenRunSpec&) = default;
};

/// How an uncertain input is distributed about the value that the case gives.
enum class Distribution { uniform, normal };

/// [[uncertainty.input]]: a number of the case that is known only so well.
struct UncertainInput {
  std::string key;  ///< "cable.youngs_modulus", or "loads.gravity.1" for an entry of a list
  Distribution distribution = Distribution::normal;
  double spread = 0;      ///< standard deviation of a normal, half width of a uniform distribution, > 0
  bool relative = false;  ///< `spread` is a share of the value
  std::string source;     ///< where the spread is from, required

  friend bool operator==(const UncertainInput&, const UncertainInput&) = default;
};

/// [uncertainty]: the parts of the validation uncertainty that are estimated (ASME V&V 20).
struct UncertaintySpec {
  bool numerical = false;  ///< mesh by Richardson extrapolation, time integration by a finer run
  int samples = 0;         ///< of the inputs; 0: not estimated
  long seed = 1;           ///< ≥ 0
  std::vector<UncertainInput> inputs;

  friend bool operator==(const UncertaintySpec&, const UncertaintySpec&) = default;
};

/// [[error_budget.item]]: one thing in which a published computation differs from the exact one.
struct BudgetItemSpec {
  std::string name;                    ///< unique: "time integration"
  std::vector<std::string> overrides;  ///< "method.name=rk4", as --set takes them
  std::string reason;                  ///< may be empty
  bool together = true;                ///< false: for information, and no part of all of them together
  /// True of an error of that computation's own numerics, which moves what was published.
  bool numerical = false;

  friend bool operator==(const BudgetItemSpec&, const BudgetItemSpec&) = default;
};

/// [error_budget]: what each item alone moves the series of a reference by, and all of them together.
struct BudgetSpec {
  std::string reference;               ///< name of a [[reference]]
  std::vector<std::string> overrides;  ///< that make the case the published computation
  double interval = 0;  ///< s, at which distances are taken beside those at the reference's times; 0: none
  std::vector<BudgetItemSpec> items;

  friend bool operator==(const BudgetSpec&, const BudgetSpec&) = default;
};

}  // namespace plumb
