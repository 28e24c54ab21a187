#pragma once

#include "engine/run/output_folder.h"
#include "report/document/document.h"

namespace plumb {

/// Writes index.html, results.json, junit.xml and summary.md. Throws OutputError.
void write_report(const Document& document, const Pictures& pictures, OutputFolder& folder);

}  // namespace plumb
