#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// How the program ends.
enum class ExitStatus {
  done = 0,
  criterion_not_met = 1,
  wrong_usage = 2,
  invalid_input = 3,
  solver_failed = 4,
  output_failed = 5,
  interrupted = 130,
};

/// What the command line said, for all verbs.
struct Options {
  std::string input;                   ///< case file or run
  std::vector<std::string> inputs;     ///< all of them, where a verb takes several; `input` is the first
  std::string other;                   ///< second file or folder of diff
  std::string kind;                    ///< of study; empty: not given
  std::string share;                   ///< of --share; empty: not given
  std::string only;                    ///< of --only; empty: not given
  std::vector<std::string> merge;      ///< of --merge
  std::vector<std::string> overrides;  ///< of --set
  std::string output;                  ///< of -o; empty: not given
  std::string csv;                     ///< of --csv; empty: not given
  std::string frames;                  ///< of --frames; empty: not given
  std::optional<int> mode;             ///< of --mode
  std::string size;                    ///< of --size
  std::string camera;                  ///< of --camera
  std::string video;                   ///< of --video
  std::vector<std::string> over;       ///< runs of --over
  std::vector<std::string> beside;     ///< runs of --beside
  bool points = false;                 ///< --points
  std::string html;                    ///< of --html; empty: not given
  std::optional<int> channel;          ///< of --channel
  std::optional<double> density;       ///< of --density
  std::optional<double> numbers;       ///< of --numbers
  std::string baseline;                ///< of --baseline; empty: not given
  bool economy = false;                ///< --economy
  bool explain = false;                ///< --explain
  std::string from;                    ///< of --from; empty: not given
  std::string to;                      ///< of --to; empty: not given
  bool accept = false;                 ///< --accept
  std::vector<std::string> limits;     ///< of --limit
  bool pdf = false;                    ///< --pdf
  std::string history;                 ///< of --history; empty: not given
  bool json = false;
  bool quiet = false;
};

}  // namespace plumb
