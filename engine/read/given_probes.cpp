#include "engine/read/given_probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/base/known_time.h"
#include "engine/base/time_interpolation.h"

namespace plumb {
namespace {

double greatest_size(const std::vector<double>& values) {
  double greatest = 0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  return greatest;
}

/// Where the times are among others, which rise strictly; nothing where one is not.
std::optional<std::vector<std::size_t>> places_among(const std::vector<double>& others,
                                                     const std::vector<double>& times) {
  std::vector<std::size_t> places;
  for (const double t : times) {
    const std::optional<KnownTime> known = known_time(others, t);
    if (!known || !known->output) return {};
    places.push_back(known->before);
  }
  return places;
}

std::vector<double> at(const std::vector<double>& values, const std::vector<std::size_t>& places) {
  std::vector<double> some;
  for (const std::size_t k : places) some.push_back(values[k]);
  return some;
}

bool same_but_for_rounding(const std::vector<double>& a, const std::vector<double>& b) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * greatest_size(a);
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(),
                                            [&](double x, double y) { return std::abs(x - y) <= rounding; });
}

bool varies(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [&](double x) { return x != values.front(); });
}

}  // namespace

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
      throw std::out_of_range("an external run is not known outside its times");
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

bool same_run(const ProbeTable& a, const ProbeTable& b) {
  if (a.times.size() > b.times.size()) return same_run(b, a);
  const auto places = places_among(b.times, a.times);
  if (!places) return false;
  bool moves = false;
  for (const Column& column : a.columns) {
    const Column* other = b.find(column.name);
    if (other == nullptr) continue;
    if (!same_but_for_rounding(column.values, at(other->values, *places))) return false;
    moves = moves || varies(column.values);
  }
  return moves;
}

}  // namespace plumb
