#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <limits>

#include "engine/errors.h"
#include "engine/input/file_text.h"
#include "engine/input/parse_json.h"
#include "engine/input/place.h"
#include "render/apng.h"
#include "render/png_file.h"
#include "report/document.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

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

/// A PNG file that a document names: within its folder, links in it followed, and nothing else.
std::string read_picture(const fs::path& folder, const std::string& file) {
  const auto refuse = [&](const char* why) {
    throw InputError(one_line(fmt::format("results.json: picture {}: {}", file, why)));
  };
  const fs::path inner = fs::path(file).lexically_normal();
  if (inner.empty() || inner.is_absolute() || *inner.begin() == "..")
    refuse("is not in the folder of the document");
  std::error_code error;
  const fs::path path = fs::canonical(folder / inner, error);
  if (error) refuse("cannot be read");
  const fs::path seen = path.lexically_relative(fs::canonical(folder, error));
  if (error || seen.empty() || *seen.begin() == "..") refuse("is a link out of the folder of the document");
  if (!fs::is_regular_file(path, error)) refuse("is no file");
  std::string png = read_whole_file(path.string());
  read_png_file(png, (folder / inner).string());
  return png;
}

std::vector<Picture> read_pictures(const Document& list, const fs::path& folder) {
  std::vector<Picture> pictures;
  for (const Document& item : list) {
    Picture picture;
    picture.file = item.at("file").get<std::string>();
    picture.title = item.at("title").get<std::string>();
    picture.alt = item.at("alt").get<std::string>();
    picture.tall = item.at("tall").get<bool>();
    picture.png = read_picture(folder, picture.file);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

/// A count, of frames or pixels.
int count_in(const Document& object, const char* key) {
  const Document& value = object.at(key);
  if (!value.is_number_integer() || value < 0 || value > std::numeric_limits<int>::max())
    throw InputError(fmt::format("results.json: animation.{} is no count", key));
  return value.get<int>();
}

}  // namespace

Document read_document(const std::string& path) {
  const std::string text = read_whole_file(path);
  const auto document = parse_json<Document>(text, path);
  if (!document.is_object() || !document.contains("schema_version") ||
      !document["schema_version"].is_number_integer())
    throw InputError(path + ": no results of Plumb: it has no schema_version that is a whole number");
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
  const fs::path path = folder;
  Pictures pictures;
  pictures.figures = read_pictures(document.at("figures"), path);
  if (document.contains("study_figures")) pictures.study = read_pictures(document.at("study_figures"), path);
  if (document.contains("error_budget_figures"))
    pictures.budget = read_pictures(document.at("error_budget_figures"), path);
  const Document& animation = document.at("animation");
  pictures.frames = count_in(animation, "frames");
  pictures.first_frame = count_in(animation, "first_frame");
  pictures.frame_rate = animation.at("frame_rate").get<double>();
  pictures.player_frame_rate = animation.at("player_frame_rate").get<double>();
  pictures.page_animation_width = count_in(animation, "width");
  pictures.page_animation_height = count_in(animation, "height");
  pictures.renderer = document.at("renderer").get<std::string>();
  if (animation.contains("notes"))
    pictures.animation_notes = animation.at("notes").get<std::vector<std::string>>();
  if (!pictures.animated()) return pictures;
  pictures.page_animation = read_picture(path, player_file);
  pictures.page_still = split_apng(pictures.page_animation, (path / player_file).string()).back();
  return pictures;
}

}  // namespace plumb
