#pragma once

#include <optional>
#include <string>

#include "engine/run/output_folder.h"
#include "engine/run/run.h"
#include "engine/study/economy/economy.h"
#include "report/program/console.h"
#include "report/program/options.h"

namespace plumb {

/// A case with what its scene needs in the place of its model, mesh and method.
struct SceneChoice {
  LoadedCase loaded;
  Economy economy;
  std::string key;  ///< of the case as it was, see choice_key()
};

/// True where --economy or method.name = "scene" asks for it. Throws UsageError where --explain has nothing
/// to explain.
bool is_left_to_scene(const LoadedCase& loaded, const Options& options);

/// What the scene of a case needs: as choice.json in the folder says, if it is of the same case and program,
/// or by a search. Says what was chosen, and with --explain why. Throws InputError.
SceneChoice choose_for_scene(const LoadedCase& loaded, const std::string& folder, const Options& options,
                             Console& console);

/// Writes choice.json.
void write_choice(const SceneChoice& choice, OutputFolder& folder);

/// The case as it is to be run: that of the choice where it is left to the scene.
LoadedCase as_the_scene_needs(const LoadedCase& loaded, const std::string& folder, const Options& options,
                              Console& console);

/// The choice that lies beside a run and that the run is of, if there is one; and keeps its file.
std::optional<Economy> choice_beside(const std::string& run_path, const Run& run, OutputFolder& folder);

}  // namespace plumb
