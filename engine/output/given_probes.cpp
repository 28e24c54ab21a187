#include "engine/output/given_probes.h"

#include <array>
#include <stdexcept>
#include <utility>

#include "engine/output/time_interpolation.h"

namespace plumb {

ProbeTable probe(const GivenRun& given) {
  ProbeTable table;
  table.times = given.times;
  for (const GivenColumn& column : given.columns)
    table.columns.push_back({column.name, column.unit, column.values});
  return table;
}

ProbeTable probe(const GivenRun& given, const std::vector<double>& times) {
  for (const double t : times)
    if (!(t >= given.times.front() && t <= given.times.back()))
      throw std::out_of_range("a given run is not known outside its times");
  ProbeTable table;
  table.times = times;
  for (const GivenColumn& column : given.columns) {
    Column sampled{column.name, column.unit, {}};
    const TimeInterpolation interpolation(given.times, column.values);
    for (const double t : times) sampled.values.push_back(interpolation.value(t));
    table.columns.push_back(std::move(sampled));
  }
  return table;
}

ProbeTable probe_without(const GivenRun& given, const std::vector<std::size_t>& outputs) {
  const auto every_second = [](const std::vector<double>& all, std::size_t first) {
    std::vector<double> some;
    for (std::size_t k = first; k < all.size(); k += 2) some.push_back(all[k]);
    return some;
  };
  const std::array times{every_second(given.times, 0), every_second(given.times, 1)};
  ProbeTable table;
  for (const std::size_t k : outputs) table.times.push_back(given.times[k]);
  for (const GivenColumn& column : given.columns) {
    const std::array values{every_second(column.values, 0), every_second(column.values, 1)};
    Column sampled{column.name, column.unit, {}};
    for (const std::size_t k : outputs) {
      const std::size_t others = (k + 1) % 2;
      sampled.values.push_back(TimeInterpolation(times[others], values[others]).value(given.times[k]));
    }
    table.columns.push_back(std::move(sampled));
  }
  return table;
}

Run reported_run(LoadedCase loaded, Provenance provenance) {
  const GivenRun& given = loaded.given_runs.at(0);
  Trajectory trajectory;
  trajectory.outcome = Outcome::completed;
  trajectory.times = given.times;
  trajectory.end_time = given.times.back();
  ProbeTable probes = probe(given);
  return {std::move(loaded), std::move(trajectory), std::move(probes), std::move(provenance)};
}

}  // namespace plumb
