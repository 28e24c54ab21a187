#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"

namespace plumb {

/// The key in results.json of what earlier runs of the case gave.
inline constexpr const char* history_key = "history";

/// Runs of a case that are shown, the latest.
inline constexpr std::size_t most_runs_of_history = 30;

/// What a history keeps of a run, from its results.json: when, of which revision, where, how it ended, what
/// each criterion found and may find, steps and seconds. Keys as in output/README.md.
Document history_entry(const Document& document);

/// The same of a run that left no report; `why` is what ended it.
Document entry_without_report(const std::string& name, const std::vector<std::string>& overrides,
                              const std::string& why);

/// An entry as a line of a history, with its end.
std::string history_line(const Document& entry);

/// What every history begins with.
inline constexpr std::string_view begin_of_history = R"({"plumb_history":)";

/// The entries of the text of a history.
struct History {
  std::vector<Document> entries;
  std::vector<std::size_t> damaged;  ///< numbers of lines, from 1, that hold no entry: passed over
  std::string newer = {};  ///< why a later version of this program is needed to add to it; empty: it is not
};
History history_in(const std::string& text);

/// Those of the same case with the same overrides, at most `most_runs_of_history`, the latest last.
std::vector<Document> of_same_case(const History& history, const Document& entry);

}  // namespace plumb
