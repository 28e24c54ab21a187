#include "report/diff/picture_moves.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/errors.h"
#include "engine/base/file_text.h"
#include "report/diff/file_difference.h"

namespace plumb {
namespace {

/// Costs that a clock measured differ from run to run.
bool shows_costs(const std::string& file) {
  return file == "figures/economy.png";
}

/// The bytes of an earlier report's figure. Throws InputError for one that is not to be had, or not within
/// the folder.
std::string earlier_bytes(const std::string& folder, const std::string& file) {
  const std::filesystem::path name = std::filesystem::path(file).lexically_normal();
  if (name.is_absolute() || name.empty() || *name.begin() == "..")
    throw InputError("it is not within the folder of the earlier report");
  return read_whole_file((std::filesystem::path(folder) / name).string());
}

PictureMove move_of(const std::string& folder, const Picture& now) {
  PictureMove move{now.file, true, -1, {}};
  try {
    const FileDifference found = compare_files(now.file, earlier_bytes(folder, now.file), now.png, {});
    move.moved = found.sameness != Sameness::identical && found.sameness != Sameness::within;
    move.density = found.number;
    move.in_words = found.in_words;
  } catch (const InputError& error) {
    move.in_words = error.what();
  }
  return move;
}

}  // namespace

std::vector<PictureMove> picture_moves(const Document& before, const std::string& folder,
                                       const std::vector<Picture>& now) {
  std::vector<std::string> earlier;
  for (const Document& figure : before.at("figures")) earlier.push_back(figure.at("file").get<std::string>());
  std::vector<PictureMove> moves;
  for (const Picture& picture : now) {
    if (shows_costs(picture.file)) continue;
    if (std::find(earlier.begin(), earlier.end(), picture.file) == earlier.end())
      moves.push_back({picture.file, true, -1, "the earlier report has no such picture"});
    else
      moves.push_back(move_of(folder, picture));
  }
  for (const std::string& file : earlier)
    if (!shows_costs(file) &&
        std::none_of(now.begin(), now.end(), [&](const Picture& picture) { return picture.file == file; }))
      moves.push_back({file, true, -1, "this run has no such picture"});
  return moves;
}

}  // namespace plumb
