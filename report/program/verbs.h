#pragma once

#include <span>
#include <string>

#include "report/program/console.h"
#include "report/program/options.h"

namespace plumb {

/// A verb of the program: what it is called, what it does, and what it takes.
struct Verb {
  std::string name;
  std::string summary;
  ExitStatus (*act)(const Options& options, Console& console) = nullptr;
  std::string input = {};   ///< what its argument is called in the help: "CASE", "RUN"; empty: takes none
  bool takes_many = false;  ///< of its argument, in Options::inputs
  bool takes_baseline = false;
  bool takes_history = false;
  bool takes_document = false;  ///< --from, in the place of its argument
  bool takes_pdf = false;       ///< --pdf
  bool takes_overrides = false;
  bool takes_output = false;
  bool takes_csv = false;
  bool takes_kind = false;     ///< of study
  bool takes_share = false;    ///< --share
  bool takes_parts = false;    ///< --only and --merge
  bool exports = false;        ///< takes --to, and a file of -o
  bool chooses = false;        ///< takes --economy and --explain
  bool draws = false;          ///< takes what to draw
  bool compares = false;       ///< takes a second path and how to compare
  bool is_estimated = false;   ///< takes --limit
  bool works_in_job = false;   ///< its work is divided among the processes of an MPI job
  bool uses_renderer = false;  ///< draws pictures, or looks at what draws them
};

/// All of them. A new one has a file of its own, NAME_verb.cpp, and its line in verbs.cpp.
std::span<const Verb> verbs();

/// What a command line asks for.
struct Command {
  const Verb* verb = nullptr;  ///< nullptr: to be told what stands in `said`
  Options options;
  std::string said = {};  ///< help or version
};

/// Reads a command line, the program's name first. Throws UsageError.
Command parse_command(int count, const char* const* arguments);

/// Reads the arguments, acts, and turns every error into one line on standard error and its exit status.
int program(int count, const char* const* arguments);

}  // namespace plumb
