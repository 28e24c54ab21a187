#pragma once

#include <map>
#include <string>
#include <vector>

/// Plumb for other C++ programs: a case goes in as text, what its run says comes out as numbers. No file is
/// read or written. Needs no header but those of C++.
namespace plumb {

/// A case with what it names.
struct CaseText {
  std::string toml;                          ///< the case file's text
  std::map<std::string, std::string> files;  ///< texts of its references and [[run]]s, by their `file` key
  std::vector<std::string> overrides;        ///< "cable.elements=8", as after --set
};

/// One scalar that a probe saw, a value an output.
struct ProbeColumn {
  std::string name;  ///< "tip.x"
  std::string unit;  ///< "m"
  std::vector<double> values;
};

/// One criterion of the case.
struct CaseVerdict {
  std::string name;    ///< "published: mid.y"
  std::string kind;    ///< "verification", "validation"
  std::string status;  ///< "passed", "failed", "not run", "another model"
  double value;        ///< what was found, in `unit`; -1: not run
  double limit;        ///< what is allowed, in `unit`
  std::string unit;
  std::string message;  ///< the verdict in words
};

/// What a run gave, up to where it ended.
struct CaseRun {
  /// "completed", "accurate", "inaccurate", "unstable", "diverged", "no-convergence", "singular",
  /// "unstable-equilibrium" or "out-of-time".
  std::string outcome;
  std::string message;                 ///< why a run ended early; else empty
  std::vector<double> times;           ///< of the outputs, s, from 0
  std::vector<std::vector<double>> q;  ///< an output: of each node x, y, z (m) and the slope's (1), 6 numbers
  std::vector<std::vector<double>> v;  ///< their rates, m/s and 1/s
  std::vector<ProbeColumn> probes;
  std::vector<CaseVerdict> verdicts;
  bool all_met = false;               ///< every verdict passed, and there is at least one
  long steps = -1;                    ///< -1: not counted
  double relative_energy_drift = -1;  ///< of the kinetic energy that moved; -1: cannot be told
};

/// Checks and integrates a case and holds it against its references, as `plumb solve` and `plumb report` do.
/// Throws std::runtime_error with one line that names line, column, value and what is allowed.
CaseRun run_case(const CaseText& text);

}  // namespace plumb
