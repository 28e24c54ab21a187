#include "engine/run/sampled_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/case/column_quantity.h"
#include "engine/integrate/method_info.h"
#include "engine/run/probes.h"

namespace plumb {
namespace {

struct Source {
  const std::vector<double>& outputs;
  std::function<ProbeTable(const std::vector<double>&)> at;
  std::function<ProbeTable(const std::vector<std::size_t>&)> without;
};

/// The outputs that are left out for any of the times, rising.
std::vector<std::size_t> all_tried(const std::vector<double>& outputs, const std::vector<KnownTime>& times) {
  std::vector<std::size_t> all;
  for (const KnownTime& time : times)
    for (const std::size_t k : tried_outputs(outputs, time)) all.push_back(k);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

SampledRun sample(const Source& source, const std::vector<double>& times) {
  constexpr double rounding = 1e-9;
  SampledRun sampled;
  std::vector<double> known;
  for (std::size_t row = 0; row < times.size(); ++row) {
    const std::optional<KnownTime> time = known_time(source.outputs, times[row]);
    if (!time) continue;
    sampled.rows.push_back(row);
    sampled.times.push_back(*time);
    known.push_back(time->time);
  }
  sampled.values = source.at(known);

  const std::vector<std::size_t> tried = all_tried(source.outputs, sampled.times);
  std::vector<double> tried_times;
  for (const std::size_t k : tried) tried_times.push_back(source.outputs[k]);
  const ProbeTable own = source.at(tried_times), without = source.without(tried);
  sampled.errors.times = known;
  for (std::size_t c = 0; c < own.columns.size(); ++c) {
    Column errors{own.columns[c].name, own.columns[c].unit, {}};
    for (const KnownTime& time : sampled.times) {
      const bool far = !(time.distance <= tried_distance(source.outputs, time) * (1 + rounding));
      double greatest = !time.output && far ? std::numeric_limits<double>::quiet_NaN() : 0;
      for (const std::size_t k : tried_outputs(source.outputs, time)) {
        const auto place =
            static_cast<std::size_t>(std::lower_bound(tried.begin(), tried.end(), k) - tried.begin());
        const double error = std::abs(without.columns[c].values[place] - own.columns[c].values[place]);
        if (!(error <= greatest)) greatest = std::isnan(greatest) ? greatest : error;
      }
      errors.values.push_back(greatest);
    }
    sampled.errors.columns.push_back(std::move(errors));
  }
  return sampled;
}

std::vector<double> every_second(const std::vector<double>& all) {
  std::vector<double> some;
  for (std::size_t k = 0; k < all.size(); k += 2) some.push_back(all[k]);
  return some;
}

/// What is compared and read off a column that the run has.
void each_aggregate(const std::vector<Comparison>& compared, const ProbeTable& outputs, const auto& visit) {
  if (outputs.times.empty()) return;
  for (const Comparison& pair : compared) {
    const ColumnQuantity quantity = column_quantity(pair.column);
    const Column* column = outputs.find(quantity.column);
    if (quantity.is_aggregate() && column != nullptr) visit(pair.column, quantity.of, *column);
  }
}

Column aggregate_column(const std::string& name, ColumnQuantity::Of of, const Column& column) {
  return {
      name, of == ColumnQuantity::Of::greatest || of == ColumnQuantity::Of::least ? column.unit : "s", {}};
}

}  // namespace

ProbeTable compared_columns(const Case& spec, const Trajectory& trajectory,
                            const std::vector<Comparison>& compared, const std::vector<double>& times) {
  ProbeTable table = probe(spec, trajectory, times), outputs;
  if (std::ranges::any_of(compared,
                          [](const Comparison& pair) { return column_quantity(pair.column).is_aggregate(); }))
    outputs = probe(spec, trajectory);
  each_aggregate(compared, outputs,
                 [&](const std::string& name, ColumnQuantity::Of of, const Column& column) {
                   Column added = aggregate_column(name, of, column);
                   for (const double t : times)
                     added.values.push_back(column_number(of, outputs.times, column.values, t).value);
                   table.columns.push_back(std::move(added));
                 });
  return table;
}

void add_aggregates(const std::vector<Comparison>& compared, const ProbeTable& outputs, SampledRun& sampled) {
  const std::vector<double> fewer_times = every_second(outputs.times);
  each_aggregate(
      compared, outputs, [&](const std::string& name, ColumnQuantity::Of of, const Column& column) {
        const std::vector<double> fewer = every_second(column.values);
        Column values = aggregate_column(name, of, column), errors = values;
        std::vector<std::string>& faults = sampled.faults[name];
        for (const KnownTime& at : sampled.times) {
          ColumnNumber number = column_number(of, outputs.times, column.values, at.time);
          const double other = column_number(of, fewer_times, fewer, at.time).value;
          const auto count = static_cast<std::size_t>(std::ranges::upper_bound(outputs.times, at.time) -
                                                      outputs.times.begin());
          const bool known = count >= fewest_outputs && std::isfinite(other);
          if (number.fault.empty() && !known)
            number.fault =
                fmt::format("{} outputs up to {:.4g} s are too few to tell how good it is", count, at.time);
          values.values.push_back(number.value);
          errors.values.push_back(known ? std::abs(number.value - other)
                                        : std::numeric_limits<double>::quiet_NaN());
          faults.push_back(std::move(number.fault));
        }
        sampled.values.columns.push_back(std::move(values));
        sampled.errors.columns.push_back(std::move(errors));
      });
}

SampledRun sample(const Case& spec, const Trajectory& trajectory, const std::vector<double>& times) {
  SampledRun sampled = sample(
      {trajectory.times, [&](const std::vector<double>& at) { return probe(spec, trajectory, at); },
       [&](const std::vector<std::size_t>& outputs) { return probe_without(spec, trajectory, outputs); }},
      times);
  // They have no rates, and so a polynomial through them would have a shape of its own.
  const MethodInfo* method = find_method(spec.method.name);
  sampled.between_is_unknown = method != nullptr && !method->dynamic;
  if (sampled.between_is_unknown)
    for (Column& column : sampled.errors.columns)
      for (std::size_t k = 0; k < column.values.size(); ++k)
        if (!sampled.times[k].output) column.values[k] = std::numeric_limits<double>::quiet_NaN();
  return sampled;
}

SampledRun sample(const GivenRun& given, const std::vector<double>& times) {
  return sample({given.times, [&](const std::vector<double>& at) { return probe(given, at); },
                 [&](const std::vector<std::size_t>& outputs) { return probe_without(given, outputs); }},
                times);
}

SampledRun sample_modes(const ProbeTable& modes, const std::vector<double>& numbers) {
  SampledRun sampled;
  sampled.values.columns = modes.columns;
  for (Column& column : sampled.values.columns) column.values.clear();
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    const auto at = std::find(modes.times.begin(), modes.times.end(), numbers[row]);
    if (at == modes.times.end()) continue;
    const auto k = static_cast<std::size_t>(at - modes.times.begin());
    sampled.rows.push_back(row);
    sampled.times.push_back({numbers[row], true, k, 0});
    for (std::size_t c = 0; c < modes.columns.size(); ++c)
      sampled.values.columns[c].values.push_back(modes.columns[c].values[k]);
    sampled.values.times.push_back(numbers[row]);
  }
  sampled.errors = sampled.values;
  for (Column& column : sampled.errors.columns) std::ranges::fill(column.values, 0.0);
  return sampled;
}

bool bearable(double interpolation_error, double tolerance) {
  return std::isfinite(interpolation_error) && interpolation_error <= bearable_share * tolerance;
}

}  // namespace plumb
