#pragma once

#include <optional>
#include <string>

#include "engine/case/case_source.h"
#include "render/scene/frame_stream.h"
#include "report/figure/other_runs.h"
#include "report/figure/scene_of_run.h"
#include "report/program/console.h"
#include "report/program/options.h"
#include "report/program/share_option.h"

namespace plumb {

/// The frames that --frames asks for: "10:20", "10:" or "10"; nothing where it is not given. Throws
/// UsageError.
std::optional<FrameRange> asked_frames(const Options& options);

/// The frames of a share, which follow one another, of so many or of those that were asked for. Throws
/// UsageError where it has none.
FrameRange frames_of_share(const Share& share, int frames, const std::optional<FrameRange>& asked);

/// The case of a run, read anew with the scene that --set, --size and --camera ask for. Throws UsageError,
/// also where --set is given a key that is not of the scene, and InputError.
LoadedCase with_asked_scene(const LoadedCase& loaded, const Options& options);

/// Adds to the scene of a run the others that --over and --beside ask for, read into `others`, which must
/// outlive what draws the scene, and the points that --points asks for; says which it leaves out. Nothing
/// where there is no motion to draw. Throws InputError, and UsageError where there is no point to show.
void add_asked(SceneOfRun& scene, const Run& run, const Options& options, std::vector<OtherRun>& others,
               Console& console);

}  // namespace plumb
