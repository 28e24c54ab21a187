#include <fmt/format.h>

#include "engine/read/case_sections.h"

namespace plumb {

TimeSpec read_time(TableReader table, std::optional<double> end) {
  constexpr double most_outputs = 1e6;
  TimeSpec time;
  time.end =
      end ? table.number("end", Range::positive("s"), *end) : table.number("end", Range::positive("s"));
  // A given run has its own times, and no outputs of ours.
  time.output_interval = end ? table.number("output_interval", Range::positive("s"), time.end)
                             : table.number("output_interval", Range::positive("s"));
  table.finish();

  if (time.output_interval > time.end) {
    table.refuse_value("output_interval", fmt::format("must be at most the end time, {} (s)", time.end));
  }
  if (time.end / time.output_interval > most_outputs) {
    table.refuse_value("output_interval",
                       fmt::format("gives {:.3g} outputs until the end time, {} s; at most {} are allowed",
                                   time.end / time.output_interval, time.end, most_outputs));
  }
  return time;
}

}  // namespace plumb
