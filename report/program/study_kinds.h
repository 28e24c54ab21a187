#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/program/options.h"
#include "report/study/made_study.h"

namespace plumb {

/// Every kind; the first one serves where a case asks for none.
std::span<const StudyKind> study_kinds();
std::vector<std::string> study_kind_names();

/// The kind that options and case ask for. Throws UsageError for a word that is none.
const StudyKind& chosen_study_kind(const Options& options, const Case& spec);

/// The study.json at a path: the file itself, or that in a folder without a run.h5. Throws InputError where
/// it cannot be read.
std::optional<NamedText> study_json_at(const std::string& path);

/// The kind that it names. Throws InputError where it is no study of this program.
const StudyKind& kind_of_study_json(const NamedText& json);

}  // namespace plumb
