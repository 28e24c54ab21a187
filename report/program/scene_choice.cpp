#include "report/program/scene_choice.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/study/economy/candidates.h"
#include "engine/study/economy/economy_json.h"
#include "engine/study/economy/model_selection.h"
#include "report/program/run_pipeline.h"
#include "report/study/economy/economy_gauge.h"
#include "report/study/economy/economy_text.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* choice_file_name = "choice.json";

std::optional<std::string> choice_text_in(const std::string& folder) {
  std::error_code ignored;
  const fs::path file = fs::path(folder) / choice_file_name;
  if (!fs::is_regular_file(file, ignored)) return {};
  const FileText read = read_file_text(file.string());
  if (!read.failure.empty()) return {};
  return read.text;
}

bool is_as_written(const std::string& text) {
  try {
    refuse_changed_text(text, choice_file_name);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// What was set of the model and the method is overruled.
CaseSource with_choice(const LoadedCase& loaded, const Candidate& candidate) {
  CaseSource source = loaded.source;
  std::erase_if(source.overrides, [&](const std::string& text) {
    return text.starts_with("method.") || text.starts_with("cable.quadrature") ||
           (candidate.cable.model != CableModel::cable && text.starts_with("cable.second_moment")) ||
           (candidate.cable.model == CableModel::rigid && text.starts_with("cable.strain"));
  });
  for (std::string& setting : candidate_overrides(loaded.spec, candidate))
    source.overrides.push_back(std::move(setting));
  return source;
}

}  // namespace

bool is_left_to_scene(const LoadedCase& loaded, const Options& options) {
  const bool left = options.economy || loaded.spec.method.name == scene_method;
  if (options.explain && !left)
    throw UsageError("--explain is for --economy, or a case with method.name = \"scene\"");
  if (left) refuse_without_method(loaded);
  return left;
}

SceneChoice choose_for_scene(const LoadedCase& loaded, const std::string& folder, const Options& options,
                             Console& console) {
  SceneChoice choice;
  choice.key = choice_key(loaded.source);
  const std::optional<std::string> text = choice_text_in(folder);
  std::optional<Economy> known =
      text && is_as_written(*text) ? decode_choice(*text, choice.key) : std::nullopt;
  if (known) {
    choice.economy = std::move(*known);
    choice.economy.reused = true;
    console.line(
        fmt::format("what the scene needs is known from an earlier search: {}/{}", folder, choice_file_name));
  } else {
    choice.economy = choose_candidate(loaded.spec, gauge_maker(loaded.spec));
  }
  const TriedCandidate& taken = *choice.economy.choice();
  choice.loaded = load_case(with_choice(loaded, taken.candidate), loaded.uses);
  if (options.explain)
    for (const std::string& line : explain(choice.economy)) console.line(line);
  console.line(economy_sentence(choice.economy, loaded.spec.scene));
  return choice;
}

void write_choice(const SceneChoice& choice, OutputFolder& folder) {
  folder.write(choice_file_name, encode_choice(choice.economy, choice.key, choice.loaded.source));
}

LoadedCase as_the_scene_needs(const LoadedCase& loaded, const std::string& folder, const Options& options,
                              Console& console) {
  if (!is_left_to_scene(loaded, options)) return loaded;
  return choose_for_scene(loaded, folder, options, console).loaded;
}

std::optional<Economy> choice_beside(const std::string& run_path, const Run& run, OutputFolder& folder) {
  std::error_code ignored;
  const fs::path beside =
      fs::is_directory(run_path, ignored) ? fs::path(run_path) : fs::path(run_path).parent_path();
  const std::optional<std::string> text = choice_text_in(beside.string());
  if (!text) return {};
  refuse_changed_text(*text, (beside / choice_file_name).string());
  std::optional<Economy> economy = decode_choice_made(*text, run.loaded.source);
  if (economy) folder.write(choice_file_name, *text);
  return economy;
}

}  // namespace plumb
