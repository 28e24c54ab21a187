#include "tests/fuzz/small_files.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "engine/base/file_text.h"

namespace plumb::fuzz {
namespace {

namespace fs = std::filesystem;

/// In the order of their names.
std::vector<std::string> toml_files(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "references")
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Without its comments, which take as long to read as all else.
std::string without_comments(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(" #");
    line = line.starts_with('#') ? "" : line.substr(0, end);
    while (line.ends_with(' ')) line.pop_back();
    if (!line.empty()) result += line + '\n';
  }
  return result;
}

/// With three rows where there are many, as the pendulum's take the longest of all to read.
std::string reference_text(const fs::path& path) {
  constexpr std::size_t many_bytes = 4000;
  std::string text = without_comments(read_whole_file(path.string()));
  const std::size_t rows = text.find("rows = [\n");
  if (text.size() < many_bytes || rows == text.npos) return text;
  std::size_t kept = rows;
  for (int line = 0; line < 4; ++line) kept = text.find('\n', kept) + 1;
  return text.erase(kept, text.find("\n]", kept) + 1 - kept);
}

}  // namespace

const CaseSource& small_source() {
  static const CaseSource source = [] {
    const std::string data = PLUMB_TEST_DATA;
    CaseSource made{{"case.toml", read_whole_file(data + "/small_case.toml")},
                    {},
                    {{"small_reference.toml", read_whole_file(data + "/small_reference.toml")}},
                    {{"run.csv", "t [s],tip.x [mm],tip.y [m]\n0,1,0\n0.5,1,-0.25\n1,1e3,-1\n"}}};
    for (const std::string folder : {"/cases/references", "/cases/shelf/references"})
      for (const auto& entry : fs::directory_iterator(PLUMB_SOURCE_DIR + folder))
        if (const fs::path& path = entry.path(); path.extension() == ".toml")
          made.references.push_back({"references/" + path.filename().string(), reference_text(path)});
    return made;
  }();
  return source;
}

std::string small_given_case() {
  return R"(title = "Given"
[[run]]
name = "g"
file = "run.csv"
program = "P 1"
columns = { "tip.x" = "tip.x", "tip.z" = "" }
units = { t = "ms" }
[cable]
length = 2
area = 1e-6
density = 1000
youngs_modulus = 1e6
[[probe]]
name = "tip"
at = 1.0
)";
}

std::vector<std::string> shelf_texts() {
  std::vector<std::string> texts;
  for (const std::string& path : toml_files(PLUMB_SOURCE_DIR "/cases"))
    if (fs::path(path).filename() != "bring_your_own.toml")  // names a long run
      texts.push_back(without_comments(read_whole_file(path)));
  return texts;
}

std::vector<std::string> reference_texts() {
  std::vector<std::string> texts;
  for (const NamedText& file : small_source().references) texts.push_back(file.text);
  texts.pop_back();
  return texts;
}

}  // namespace plumb::fuzz
