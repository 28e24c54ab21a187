#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <limits>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "engine/base/interrupt.h"
#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/base/place.h"
#include "render/image/apng.h"
#include "render/image/png.h"
#include "render/image/png_file.h"
#include "report/base/document_value.h"
#include "report/document/document.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The keys without which a document is not that of a run.
constexpr std::array run_keys{"title",      "headline",        "outcome",   "outcome_reason", "complete",
                              "verdicts",   "solve",           "errors",    "references",     "energy",
                              "probes",     "figures",         "animation", "case",           "seconds",
                              "provenance", "all_criteria_met"};

template <typename Enum, std::size_t n>
Enum from_word(const std::string& text, const std::array<Enum, n>& all) {
  for (const Enum value : all)
    if (word(value) == text) return value;
  throw InputError(fmt::format("results.json: \"{}\" is unknown", text));
}

/// Reads the PNG files that a document names: those within its folder, links followed, and nothing else.
class PictureReader {
 public:
  explicit PictureReader(fs::path folder) : folder_(std::move(folder)) {}

  std::string read(const std::string& file) {
    const fs::path inner = fs::path(file).lexically_normal();
    const bool whole = !file.empty() && file.find('\0') == std::string::npos;
    if (!whole || inner.is_absolute() || *inner.begin() == "..")
      refuse(file, "is not in the folder of the document");
    std::error_code error;
    const fs::path path = fs::canonical(folder_ / inner, error);
    if (error) refuse(file, "cannot be read");
    const fs::path seen = path.lexically_relative(fs::canonical(folder_, error));
    if (error || seen.empty() || *seen.begin() == "..")
      refuse(file, "is a link out of the folder of the document");
    if (!fs::is_regular_file(path, error)) refuse(file, "is no file");
    std::string png = read_whole_file(path.string(), InputKind::picture);
    if (png.size() > room_) refuse(file, "and those before it are too large for a page");
    room_ -= png.size();
    read_png_file(png, (folder_ / inner).string());
    return png;
  }

  std::vector<Picture> read_all(const Document& list) {
    std::vector<Picture> pictures;
    for (const Document& item : list) {
      stop_if_interrupted();
      Picture picture;
      picture.file = item.at("file").get<std::string>();
      picture.title = item.at("title").get<std::string>();
      picture.alt = item.at("alt").get<std::string>();
      picture.tall = item.at("tall").get<bool>();
      picture.png = read(picture.file);
      picture.page_png = encode_png(decode_png(picture.png, picture.file), {}, PngEffort::page);
      pictures.push_back(std::move(picture));
    }
    return pictures;
  }

 private:
  [[noreturn]] static void refuse(const std::string& file, const char* why) {
    throw InputError(one_line(fmt::format("results.json: picture '{}': {}", file, why)));
  }

  fs::path folder_;
  std::size_t room_ = 256U << 20;  ///< bytes
};

/// A count, of frames or pixels.
int count_in(const Document& object, const char* key) {
  const Document& value = object.at(key);
  if (!value.is_number_integer() || value < 0 || value > std::numeric_limits<int>::max())
    throw InputError(fmt::format("results.json: animation.{} is no count", key));
  return value.get<int>();
}

Coverage read_coverage(const Document& json) {
  Coverage coverage;
  const auto count = [&](const char* key) { return json.at(key).get<std::size_t>(); };
  const auto number = [&](const char* key) { return json.at(key).get<double>(); };
  coverage.demanded = count("demanded");
  coverage.compared = count("compared");
  coverage.interpolated = count("interpolated");
  coverage.first = number("first");
  coverage.last = number("last");
  coverage.longest_gap = number("longest_gap");
  coverage.interpolation_error = number("interpolation_error");
  coverage.share = number("share");
  coverage.allowance = json.at("allowance").get<std::string>();
  coverage.lacking = json.at("lacking").get<std::string>();
  return coverage;
}

}  // namespace

Document read_document(const std::string& path, bool may_be_changed) {
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
  if (!may_be_changed) refuse_changed(document, path, false);
  return document;
}

std::vector<Verdict> verdicts_of(const Document& document) {
  std::vector<Verdict> verdicts;
  for (const Document& item : document.at("verdicts")) {
    const auto text = [&](const char* key) { return item.at(key).get<std::string>(); };
    Verdict verdict;
    verdict.kind = from_word(text("kind"), std::array{VerdictKind::verification, VerdictKind::validation,
                                                      VerdictKind::regression, VerdictKind::performance});
    verdict.status = from_word(text("status"), statuses_by_urgency);
    verdict.name = text("name");
    verdict.criterion = text("criterion");
    // What is not finite has no number in JSON.
    verdict.value = number_of(item.at("value"));
    verdict.limit = item.at("limit").get<double>();
    verdict.unit = text("unit");
    verdict.detail = text("detail");
    verdict.message = text("message");
    verdict.reason = text("reason");
    verdict.time = item.value("time", -1.0);
    if (item.contains("coverage")) verdict.coverage = read_coverage(item.at("coverage"));
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

void check_claims(const Document& document, const std::string& path) {
  std::vector<Verdict> verdicts = verdicts_of(document);
  for (const Verdict& verdict : verdicts)
    if (verdict.status == VerdictStatus::passed &&
        (!within(verdict.value, verdict.limit) ||
         (verdict.coverage && (verdict.coverage->compared == 0 || !verdict.coverage->lacking.empty()))))
      throw InputError(one_line(
          fmt::format("{}: the verdict '{}' is passed, which its numbers do not say", path, verdict.name)));
  const bool complete = document.at("complete").get<bool>(), met = complete && all_met(verdicts);
  // What moved since an earlier report makes a run no less accurate.
  std::erase_if(verdicts, [](const Verdict& verdict) { return verdict.kind == VerdictKind::regression; });
  const bool says_accurate = document.at("outcome") == "accurate" ||
                             document.at("headline").get<std::string>().starts_with("Accurate");
  if ((!met && document.at("all_criteria_met").get<bool>()) ||
      (!(complete && all_met(verdicts)) && says_accurate))
    throw InputError(path + ": says that all criteria are met, which its verdicts do not");
}

Pictures pictures_of(const Document& document, const std::string& folder) {
  PictureReader reader(folder);
  Pictures pictures;
  pictures.figures = reader.read_all(document.at(figures_key));
  for (const auto& [key, list] : document.items())
    if (is_figures_key(key) && key != figures_key) pictures.sections[key] = reader.read_all(list);
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
  pictures.page_animation = reader.read(player_file);
  pictures.page_still = split_apng(pictures.page_animation, (fs::path(folder) / player_file).string()).back();
  return pictures;
}

}  // namespace plumb
