#pragma once

#include <string>

#include "report/base/document_value.h"
#include "report/figure/pictures.h"
#include "report/verdict/results.h"

namespace plumb {

/// The document of a run that was evaluated and drawn.
Document document_of(const Results& results, const Pictures& pictures);

/// The text of results.json, with its check sum where it is to have one; what has no version never has.
std::string to_json(const Document& document, bool has_sum = true);

/// Reads results.json. Throws InputError for a file that cannot be read, is not JSON, is of a later version
/// or is not that of a run, and unless it may be one for a file that was changed after it was written. One
/// without a check sum is taken as it is.
Document read_document(const std::string& path, bool may_be_changed = false);

/// The verdicts of a document, in its order.
std::vector<Verdict> verdicts_of(const Document& document);

/// Throws InputError, which names `path`, where a document that was changed says more than its verdicts do:
/// that one is passed whose value is not within its limit or that was judged over too little, that all
/// criteria are met or the run is accurate where they are not or there is none.
void check_claims(const Document& document, const std::string& path);

/// True for "figures" and for what ends in "_figures": the keys of a document's lists of figures.
bool is_figures_key(std::string_view key);

/// What was drawn, with the pictures' bytes read from `folder`. Throws InputError where one is missing, is no
/// PNG file, or is not in that folder.
Pictures pictures_of(const Document& document, const std::string& folder);

/// junit.xml: a suite for the integration and one for each kind of verdict, a test case a criterion.
std::string to_junit(const Document& document);

/// summary.md, for a CI page; below 64 KiB.
std::string to_summary(const Document& document);

}  // namespace plumb
