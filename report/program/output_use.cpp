#include "report/program/output_use.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "render/gl/gl_context.h"
#include "render/gl/text.h"
#include "report/document/report_formats.h"

namespace plumb {

namespace fs = std::filesystem;

std::string file_in(const std::string& path, const char* name) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) ? (fs::path(path) / name).string() : path;
}

std::vector<std::string> files_read(const LoadedCase& loaded, const Options& options) {
  std::vector<std::string> files{options.input};
  const fs::path folder = fs::path(options.input).parent_path();
  for (const ReferenceUse& use : loaded.spec.references) files.push_back((folder / use.file).string());
  for (const GivenRunSpec& given : loaded.spec.given_runs) {
    files.push_back((folder / given.file).string());
    for (const GivenPointSpec& point : given.points) files.push_back((folder / point.file).string());
  }
  if (!options.baseline.empty()) files.push_back(file_in(options.baseline, "results.json"));
  return files;
}

std::vector<std::string> source_files(const std::string& path) {
  std::error_code ignored;
  const fs::path folder = fs::is_directory(path, ignored) ? fs::path(path) : fs::path(path).parent_path();
  std::vector<std::string> files{file_in(path, "run.h5")};
  for (const char* name : {"study.h5", "study.json", "assessment.json", "choice.json"})
    files.push_back((folder / name).string());
  return files;
}

std::string folder_name_of(const std::string& case_path) {
  const std::string name = fs::path(case_path).stem().string();
  if (!is_name_beneath(name))
    throw UsageError(
        fmt::format("{}: its results would be in a folder '{}', which is none of its own; rename "
                    "it, or name a folder with -o",
                    case_path, name));
  return name;
}

FolderUse folder_for(const LoadedCase& loaded, const Options& options, Console& console) {
  return {.formats = report_files(),
          .reads = files_read(loaded, options),
          .remark = [&console](const std::string& text) { console.remark(text); }};
}

FolderUse folder_from(const std::string& run_path, Console& console) {
  return {.formats = report_files(),
          .sources = source_files(run_path),
          .remark = [&console](const std::string& text) { console.remark(text); }};
}

void refuse_to_overwrite(const std::string& option, const std::string& file,
                         const std::vector<std::string>& reads, const std::string& folder) {
  const fs::path parent = fs::absolute(file).parent_path();
  // The folder of results is there once it is written.
  if (std::error_code error;
      !fs::is_directory(parent, error) && (folder.empty() || fs::weakly_canonical(parent, error) != folder))
    throw WriteError(file, fmt::format("there is no folder {}", parent.string()));
  struct stat own {
  }, read{};
  if (::stat(file.c_str(), &own) == 0 && S_ISREG(own.st_mode))
    for (const std::string& path : reads)
      if (::stat(path.c_str(), &read) == 0 && read.st_dev == own.st_dev && read.st_ino == own.st_ino)
        throw UsageError(
            fmt::format("{} {}: is what is read from {}; name another file", option, file, path));
  if (folder.empty()) return;
  std::error_code ignored;
  const fs::path place = fs::weakly_canonical(fs::absolute(file), ignored);
  const fs::path name = place.lexically_relative(folder);
  const std::string below = name.generic_string();
  if (!name.empty() && *name.begin() != ".." &&
      (belongs_to(FolderContent::results, below, report_files()) || below == manifest_name ||
       below == "frames" || below == "figures"))
    throw UsageError(
        fmt::format("{} {}: has the name of a file of the output folder; name another file", option, file));
}

std::string try_drawing() {
  const GlContext context;
  const Font fonts;
  return context.info().fingerprint();
}

}  // namespace plumb
