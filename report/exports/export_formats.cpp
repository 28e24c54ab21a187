#include "report/exports/export_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/errors.h"

namespace plumb {

// In the order of the help.
#define PLUMB_EXPORT_FORMATS(format) format(vtkhdf) format(vtp) format(glb)

#define PLUMB_DECLARE(name) ExportFormat name##_export();
PLUMB_EXPORT_FORMATS(PLUMB_DECLARE)
#undef PLUMB_DECLARE

std::span<const ExportFormat> export_formats() {
#define PLUMB_LIST(name) name##_export(),
  static const std::vector<ExportFormat> all{PLUMB_EXPORT_FORMATS(PLUMB_LIST)};
#undef PLUMB_LIST
  return all;
}

const ExportFormat& export_format(const std::string& name) {
  std::vector<std::string_view> names;
  for (const ExportFormat& format : export_formats()) {
    if (format.name == name) return format;
    names.push_back(format.name);
  }
  throw UsageError(fmt::format("--to {}: must be one of {}", name, fmt::join(names, ", ")));
}

void keep_exports(OutputFolder& folder) {
  for (const ExportFormat& format : export_formats()) folder.keep(std::string(format.file));
  std::string piece;
  for (int k = 0; k == 0 || folder.holds(piece); ++k) folder.keep(piece = fmt::format("vtp/{:04}.vtp", k));
}

}  // namespace plumb
