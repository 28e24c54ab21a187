#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/program/print_json.h"
#include "report/program/verbs.h"
#include "report/program/work.h"

namespace plumb {

ExitStatus render_verb(const Options& options, Talk& talk) {
  Stages stages;
  stages.begin("reading");
  const Run run = find_run(options.input);
  OutputFolder folder(output_path_of_run(options));
  write_run(run, folder);
  for (const char* report_file : {"index.html", "results.json", "junit.xml", "summary.md", "study.h5"})
    folder.keep(report_file);
  const Pictures pictures = draw_pictures(run, folder, stages, talk);
  folder.commit();
  talk.line(fmt::format("{} and {}: {}", counted(std::ssize(pictures.figures), "figure", "figures"),
                        counted(pictures.frames, "frame", "frames"), folder.path()));
  say_stages(stages, talk);
  if (options.json) {
    nlohmann::ordered_json json{
        {"folder", folder.path()}, {"frames", pictures.frames}, {"figures", nlohmann::ordered_json::array()}};
    for (const Picture& picture : pictures.figures) json["figures"].push_back(picture.file);
    print_json(json);
  }
  return ExitStatus::done;
}

}  // namespace plumb
