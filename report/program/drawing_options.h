#pragma once

#include <optional>
#include <string>

#include "engine/input/case_source.h"
#include "render/frame_stream.h"
#include "report/program/options.h"

namespace plumb {

/// The frames that --frames asks for: "10:20", "10:" or "10"; nothing where it is not given. Throws
/// UsageError.
std::optional<FrameRange> asked_frames(const Options& options);

/// The case of a run, read anew with the scene that --size and --camera ask for. Throws UsageError and
/// InputError.
LoadedCase with_asked_scene(const LoadedCase& loaded, const Options& options);

}  // namespace plumb
