#include "report/program/study_kinds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/message.h"
#include "engine/base/nearest.h"
#include "engine/base/parse_json.h"

namespace plumb {

// Every kind, the one that serves where a case asks for none first.
#define PLUMB_STUDIES(study) \
  study(work_precision) study(stability) study(variants) study(sweep) study(economy) study(sensitivity)

#define PLUMB_DECLARE(name) StudyKind name##_study();
PLUMB_STUDIES(PLUMB_DECLARE)
#undef PLUMB_DECLARE

std::span<const StudyKind> study_kinds() {
#define PLUMB_LIST(name) name##_study(),
  static const std::vector<StudyKind> all{PLUMB_STUDIES(PLUMB_LIST)};
#undef PLUMB_LIST
  return all;
}

std::vector<std::string> study_kind_names() {
  std::vector<std::string> names;
  for (const StudyKind& kind : study_kinds()) names.push_back(kind.name);
  return names;
}

const StudyKind& chosen_study_kind(const Options& options, const Case& spec) {
  for (const StudyKind& kind : study_kinds())
    if (options.kind.empty() ? kind.asked_for(spec) : kind.name == options.kind) return kind;
  if (options.kind.empty()) return study_kinds().front();
  const std::vector<std::string> names = study_kind_names();
  throw UsageError(fmt::format("'{}' is no kind of study{}; there are {}", options.kind,
                               suggestion(options.kind, names), fmt::join(names, ", ")));
}

std::optional<NamedText> study_json_at(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path file = path;
  if (fs::is_directory(file, ignored)) {
    if (fs::exists(file / "run.h5", ignored) || !fs::exists(file / study_json_name, ignored)) return {};
    file /= study_json_name;
  } else if (file.filename() != study_json_name) {
    return {};
  }
  return NamedText{file.string(), read_whole_file(file.string())};
}

const StudyKind& kind_of_study_json(const NamedText& json) {
  const auto value = parse_json<nlohmann::json>(json.text, json.name);
  const std::string name = value.is_object() && value.contains("kind") && value["kind"].is_string()
                               ? value["kind"].get<std::string>()
                               : std::string();
  for (const StudyKind& kind : study_kinds())
    if (kind.read != nullptr && kind.name == name) return kind;
  throw InputError(one_line(fmt::format("{}: holds no study of this program", json.name)));
}

}  // namespace plumb
