#pragma once

#include "report/program/console.h"
#include "report/program/options.h"

namespace plumb {

/// `plumb report --from results.json`: the page, junit.xml and summary.md from the document and the pictures
/// that lie beside it, into its folder or that of -o. Nothing is solved, drawn or compared. Throws InputError
/// for a document or picture that cannot be used.
ExitStatus report_from_document(const Options& options, Console& console);

}  // namespace plumb
