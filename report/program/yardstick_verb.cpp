#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/run/provenance.h"
#include "engine/study/work_precision/cheapest.h"
#include "engine/study/yardstick.h"
#include "report/program/print_json.h"
#include "report/program/verbs.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

ExitStatus do_yardstick(const Options& options, Console& console) {
  const Yardstick taken = yardstick();
  const double greatest = *std::max_element(taken.repeats.begin(), taken.repeats.end());
  console.line(fmt::format("{:.4g} s: {}, the least of {} times; the greatest {}", taken.seconds, taken.work,
                           taken.repeats.size(), duration_in_words(greatest)));
  console.line(
      fmt::format("In a [[run]] whose seconds were measured here: yardstick = {:.4g}", taken.seconds));
  if (!options.json) return ExitStatus::done;
  Json json{{"seconds", taken.seconds}, {"repeats", taken.repeats}, {"work", taken.work},
            {"steps", taken.steps},     {"tip", taken.tip},         {"version", yardstick_version}};
  for (const auto& [name, value] : provenance_now()) json["provenance"][name] = value;
  print_json(json);
  return ExitStatus::done;
}

}  // namespace

Verb yardstick_verb() {
  return {.name = "yardstick",
          .summary = "the time of a fixed piece of work here, to scale times of other machines by",
          .act = do_yardstick};
}

}  // namespace plumb
