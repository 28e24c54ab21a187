#pragma once

#include <kainjow/mustache.hpp>

#include "report/document/document.h"

/// Tables of the page of a run, as rows for its template.
namespace plumb {

/// The distances to each reference, a row a series.
kainjow::mustache::data error_rows(const Document& document);

/// The references with their source, how they were obtained and their notes.
kainjow::mustache::data reference_rows(const Document& document);

/// How the integration went and what it cost.
kainjow::mustache::data cost_rows(const Document& document);

/// The case as it was understood.
kainjow::mustache::data case_rows(const Document& document);

}  // namespace plumb
