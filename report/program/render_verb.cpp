#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus render_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const FoundRun found = find_run(options.input);
  OutputFolder folder(options.output.empty() ? found.folder : options.output);
  folder.start_from(found.folder);
  const Pictures pictures = draw_pictures(found.run, folder, stages, talk);
  folder.commit();
  talk.line(
      fmt::format("{} figures and {} frames: {}", pictures.figures.size(), pictures.frames, folder.path()));
  say_stages(stages, talk);
  if (options.json) {
    nlohmann::ordered_json json{
        {"folder", folder.path()}, {"frames", pictures.frames}, {"figures", nlohmann::ordered_json::array()}};
    for (const Picture& picture : pictures.figures) json["figures"].push_back(picture.file);
    std::fputs((json.dump(1) + "\n").c_str(), stdout);
  }
  return ExitStatus::done;
}

}  // namespace plumb
