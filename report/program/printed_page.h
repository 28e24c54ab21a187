#pragma once

#include "engine/run/output_folder.h"
#include "report/program/options.h"

namespace plumb {

/// The page on paper, in an output folder.
inline constexpr const char* pdf_file = "report.pdf";

/// Where --pdf is given and none of chromium, chromium-browser and google-chrome is found by PATH, throws
/// OutputError that says so, before anything is done.
void check_pdf(const Options& options);

/// Where --pdf is given, prints the index.html of a folder in the making and adds it as report.pdf. Throws
/// OutputError where the browser does not print it, Interrupted when the user stops it; it is ended then.
void add_pdf(OutputFolder& folder, const Options& options);

}  // namespace plumb
