#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/run/output_folder.h"
#include "engine/run/run.h"

namespace plumb {

/// A finished run that is exported, and what it is called beside others.
struct ExportedRun {
  std::string label;
  Run run;
};

/// Takes a file, "run.vtkhdf", by its name below the folder that it is written to.
using PutFile = std::function<void(const std::string& name, std::string_view bytes)>;

/// A format of other programs for whole runs.
struct ExportFormat {
  std::string_view name;  ///< of --to
  std::string_view
      file;  ///< that is written into a run's folder; of a format of many files the first to open
  std::string_view summary;  ///< what it is, and for whom
  bool many_files = false;   ///< others stand beside it
  /// Writes one run or more. Throws OutputError where one has nothing that could be shown, and Interrupted.
  void (*write)(const std::vector<ExportedRun>& runs, const PutFile& put) = nullptr;
};

/// All of them. A new one has a file of its own, and its line in export_formats.cpp.
std::span<const ExportFormat> export_formats();

/// The format of that name. Throws UsageError with those that there are.
const ExportFormat& export_format(const std::string& name);

/// Takes what was exported from the run of a folder over into the new one.
void keep_exports(OutputFolder& folder);

}  // namespace plumb
