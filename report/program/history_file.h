#pragma once

#include <string>

#include "report/document/history.h"
#include "report/program/console.h"

/// The file of --history: a line of JSON a run, to which any number of programs may add at the same time.
namespace plumb {

/// The last 64 MiB of a history; without entries where there is no file or an empty one. Throws InputError,
/// which names the file, for one that is no history or cannot be read.
History read_history(const std::string& path);

/// Reads it before any work, and remarks on lines that are damaged: they stay and are passed over.
void check_history(const std::string& path, Console& console);

/// Adds a line, whole or not at all, unless that very line is there already. A last line that was
/// cut off stays as it is, on a line of its own. Throws InputError as above, WriteError where it cannot be
/// written.
void append_history(const std::string& path, const Document& entry);

/// Puts what earlier runs of its case gave, and it itself, into a results.json, under `history`.
void add_history(Document& document, const std::string& path);

}  // namespace plumb
