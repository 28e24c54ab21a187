#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "engine/errors.h"
#include "engine/input/file_text.h"
#include "render/apng.h"
#include "report/document.h"

namespace plumb {
namespace {

/// The keys without which a document is not that of a run.
constexpr std::array run_keys{"title",      "headline",        "outcome",   "outcome_reason", "complete",
                              "verdicts",   "solve",           "errors",    "references",     "energy",
                              "probes",     "figures",         "animation", "case",           "seconds",
                              "provenance", "all_criteria_met"};

template <typename Enum>
Enum from_word(const std::string& text, std::initializer_list<Enum> all) {
  for (const Enum value : all)
    if (word(value) == text) return value;
  throw InputError(fmt::format("results.json: \"{}\" is unknown", text));
}

std::vector<Picture> read_pictures(const Document& list, const std::filesystem::path& folder) {
  std::vector<Picture> pictures;
  for (const Document& item : list) {
    Picture picture;
    picture.file = item.at("file").get<std::string>();
    picture.title = item.at("title").get<std::string>();
    picture.alt = item.at("alt").get<std::string>();
    picture.tall = item.at("tall").get<bool>();
    picture.png = read_whole_file((folder / picture.file).string(), InputKind::picture);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace

Document read_document(const std::string& path) {
  const std::string text = read_whole_file(path);
  Document document;
  try {
    document = Document::parse(text);
  } catch (const Document::parse_error& error) {
    throw InputError(fmt::format("{}: not JSON: {}", path, error.what()));
  }
  if (!document.is_object() || !document.contains("schema_version") ||
      !document["schema_version"].is_number_integer())
    throw InputError(path + ": no results of Plumb: schema_version is missing");
  const long version = document["schema_version"].get<long>();
  if (version != results_version)
    throw InputError(fmt::format("{}: schema_version is {}; this program reads version {}", path, version,
                                 results_version));
  for (const char* key : run_keys)
    if (!document.contains(key))
      throw InputError(fmt::format("{}: {} is missing: not the results of a run", path, key));
  return document;
}

std::vector<Verdict> verdicts_of(const Document& document) {
  std::vector<Verdict> verdicts;
  for (const Document& item : document.at("verdicts")) {
    const auto text = [&](const char* key) { return item.at(key).get<std::string>(); };
    Verdict verdict;
    verdict.kind = from_word(text("kind"), {VerdictKind::verification, VerdictKind::validation,
                                            VerdictKind::regression, VerdictKind::performance});
    verdict.status =
        from_word(text("status"), {VerdictStatus::not_run, VerdictStatus::passed, VerdictStatus::failed});
    verdict.name = text("name");
    verdict.criterion = text("criterion");
    // What is not finite has no number in JSON.
    const Document& value = item.at("value");
    verdict.value = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
    verdict.limit = item.at("limit").get<double>();
    verdict.unit = text("unit");
    verdict.detail = text("detail");
    verdict.message = text("message");
    verdict.reason = text("reason");
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

Pictures pictures_of(const Document& document, const std::string& folder) {
  const std::filesystem::path path = folder;
  Pictures pictures;
  pictures.figures = read_pictures(document.at("figures"), path);
  if (document.contains("study_figures")) pictures.study = read_pictures(document.at("study_figures"), path);
  if (document.contains("error_budget_figures"))
    pictures.budget = read_pictures(document.at("error_budget_figures"), path);
  const Document& animation = document.at("animation");
  pictures.frames = animation.at("frames").get<int>();
  pictures.first_frame = animation.at("first_frame").get<int>();
  pictures.frame_rate = animation.at("frame_rate").get<double>();
  pictures.player_frame_rate = animation.at("player_frame_rate").get<double>();
  pictures.page_animation_width = animation.at("width").get<int>();
  pictures.page_animation_height = animation.at("height").get<int>();
  pictures.renderer = document.at("renderer").get<std::string>();
  if (animation.contains("notes"))
    pictures.animation_notes = animation.at("notes").get<std::vector<std::string>>();
  if (!pictures.animated()) return pictures;
  const std::string player = (path / player_file).string();
  pictures.page_animation = read_whole_file(player, InputKind::picture);
  pictures.page_still = split_apng(pictures.page_animation, player).back();
  return pictures;
}

}  // namespace plumb
