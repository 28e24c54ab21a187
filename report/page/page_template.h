#pragma once

#include <kainjow/mustache.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/case/case_source.h"
#include "engine/run/provenance.h"
#include "report/base/stages.h"
#include "report/figure/pictures.h"

/// What the pages are made with.
namespace plumb {

/// A template with its values filled in, escaped for HTML.
std::string fill_in(std::string_view text, const kainjow::mustache::data& values);

/// "data:image/png;base64,…".
std::string data_uri(const std::string& png);

/// Rows of {{name}} and {{value}}.
kainjow::mustache::data pair_rows(const std::vector<std::pair<std::string, std::string>>& items);

/// {{{image}}}, which suits the theme of the page where the picture was drawn for it, {{alt}}, {{title}},
/// {{file}} and {{tall}} of a picture; {{caption}} is its title as a sentence, and `more`.
kainjow::mustache::data picture_values(const Picture& picture, const std::string& more = "");
/// Rows of them.
kainjow::mustache::data picture_rows(const std::vector<Picture>& pictures);

/// Sets {{{case_source}}}, the case's overrides and its text, which is seen at once where `open`, and
/// {{{provenance}}}, with where the time went.
void set_case_and_provenance(kainjow::mustache::data& page, const CaseSource& source,
                             const Provenance& provenance, const Stages& stages, bool open);

/// The same from the document of a report.
void set_case_and_provenance(kainjow::mustache::data& page, const nlohmann::ordered_json& document);

}  // namespace plumb
