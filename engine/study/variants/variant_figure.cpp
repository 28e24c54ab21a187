#include "engine/study/variants/variant_figure.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "engine/base/dense.h"
#include "engine/case/column_quantity.h"
#include "engine/case/variant_quantities.h"
#include "engine/integrate/method_info.h"

namespace plumb {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Greatest distance of a node at the outputs that both have; none of other meshes, where they do not end
/// together, where they have no output after the start, or where one is not a number.
double distance(const Trajectory& a, const Trajectory& b) {
  constexpr double same_time = 1e-9;  // s
  if (a.times.empty() || b.times.empty() || std::abs(a.times.back() - b.times.back()) > same_time)
    return none;
  double worst = none;
  bool moved = false;
  std::size_t j = 0;
  for (std::size_t k = 0; k < a.times.size(); ++k) {
    while (j < b.times.size() && b.times[j] < a.times[k] - same_time) ++j;
    if (j == b.times.size() || b.times[j] > a.times[k] + same_time) continue;
    if (a.q[k].size() != b.q[j].size()) return none;
    moved = moved || a.times[k] > 0;
    for (Eigen::Index node = 0; node + 3 <= a.q[k].size(); node += 6) {
      const double here = (a.q[k].segment<3>(node) - b.q[j].segment<3>(node)).norm();
      if (std::isnan(here)) return none;
      if (!(here <= worst)) worst = here;
    }
  }
  return moved ? worst : none;
}

bool any_is_not_a_number(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); });
}

/// The values of the first column, one an output interval: the last output may come sooner after the others.
std::vector<double> even_samples(const VariantResult& variant) {
  if (variant.probes.columns.empty()) return {};
  std::vector<double> samples = variant.probes.columns.front().values;
  const std::vector<double>& times = variant.probes.times;
  const double interval = variant.run.time.output_interval;
  if (times.size() > 1 && times.back() - times[times.size() - 2] < 0.999 * interval) samples.pop_back();
  return samples;
}

double of_run(const ExpectationSpec& expected, const VariantResult& variant,
              const std::vector<VariantResult>& all) {
  const Trajectory& t = variant.trajectory;
  const std::string& what = expected.quantity;
  if (what == "end-time") return t.end_time;
  if (what == "constraint-drift") return t.constraint_drift < 0 ? none : t.constraint_drift;
  if (what == "growth") return growth_of(even_samples(variant));
  if (what == "distance") {
    for (const VariantResult& other : all)
      if (other.spec.name == expected.from) return distance(t, other.trajectory);
    return none;
  }
  // Of equilibria under a load that grows there is no energy to keep.
  const bool is_energy = what.starts_with("energy-");
  if (t.energies.empty() || (is_energy && !t.equilibria.negative_eigenvalues.empty())) return none;
  const double first = t.energies.front().total(), last = t.energies.back().total();
  if (what == "energy-ratio") return last / first;
  if (what == "energy-change") return (last - first) / t.kinetic_scale();
  if (what == "energy-drift") return t.relative_energy_drift() < 0 ? none : t.relative_energy_drift();
  const ColumnQuantity quantity = column_quantity(what);
  const Column* column = variant.probes.find(quantity.column);
  if (column == nullptr || column->values.empty() || any_is_not_a_number(column->values)) return none;
  const MethodInfo* method = find_method(variant.run.method.name);
  const std::vector<double>& times = variant.probes.times;
  return column_number(quantity.of, times, column->values, times.back(), method != nullptr && method->dynamic)
      .value;
}

std::string unit_of(const ExpectationSpec& expected, const Case& run) {
  for (const VariantQuantity& quantity : variant_quantities())
    if (quantity.name == expected.quantity) return std::string(quantity.unit);
  return std::string(unit(column_quantity(expected.quantity), ProbeColumns(run.probes)).value_or(""));
}

}  // namespace

double growth_of(const std::vector<double>& samples) {
  constexpr std::size_t fewest = 10;
  if (samples.size() < fewest) return none;
  const std::size_t first = samples.size() / 2;
  const auto rows = static_cast<Eigen::Index>(samples.size() - first - 2);
  Eigen::MatrixXd left(rows, 3);
  Eigen::VectorXd right(rows);
  double scale = 0;
  for (const double x : samples) scale = std::max(scale, std::abs(x));
  for (Eigen::Index k = 0; k < rows; ++k) {
    const std::size_t at = first + static_cast<std::size_t>(k);
    left.row(k) << samples[at + 1] / scale, -samples[at] / scale, 1;
    right[k] = samples[at + 2] / scale;
  }
  if (!left.allFinite()) return none;
  const auto [x, rank] = least_squares(left, right);
  if (rank < 3) return none;
  const std::complex<double> root = std::sqrt(std::complex<double>(x[0] * x[0] / 4 - x[1]));
  return std::max(std::abs(x[0] / 2 + root), std::abs(x[0] / 2 - root));
}

ExpectationFound find_figure(const ExpectationSpec& expected, const VariantResult& variant,
                             const std::vector<VariantResult>& all) {
  return {expected, unit_of(expected, variant.run), of_run(expected, variant, all)};
}

bool VariantResult::met() const {
  return outcome_met() && std::all_of(expectations.begin(), expectations.end(),
                                      [](const ExpectationFound& found) { return found.met(); });
}

}  // namespace plumb
