#pragma once

#include <string>

#include "report/document/document.h"
#include "report/program/options.h"

namespace plumb {

/// The results.json of a path to it or to its folder. Throws InputError, unless it may be one for a file that
/// was changed after it was written.
Document find_document(const std::string& path, bool may_be_changed = false);

/// The same of a report that is whole enough to be a baseline. Throws InputError.
Document find_baseline(const std::string& path);

/// Adds what moved since earlier reports: with --baseline verdicts of regression, and always, under
/// `last_run`, what changed from the report that lies in `folder` now, if one does that can be read. Throws
/// InputError for a baseline that cannot be used. Where a baseline that was rounded otherwise moved, the run
/// is made once more, to tell what a rounding does to it.
void hold_against_earlier(Document& document, const Run& run, const Pictures& pictures,
                          const Options& options, const std::string& folder);

}  // namespace plumb
