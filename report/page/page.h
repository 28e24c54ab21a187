#pragma once

#include <span>
#include <string>

#include "engine/run/output_folder.h"
#include "report/page/page_section.h"

namespace plumb {

/// index.html: the report as one file that asks nothing of anywhere and can be read without scripts. All that
/// it says is in the document, which may have any of `sections`. Throws nlohmann's exceptions where the
/// document lacks what output/README.md says of it.
std::string to_page(const Document& document, const Pictures& pictures,
                    std::span<const PageSection> sections = {});

/// Writes index.html and a file of each format. Throws OutputError.
void write_report(const Document& document, const Pictures& pictures, std::span<const PageSection> sections,
                  OutputFolder& folder);

}  // namespace plumb
