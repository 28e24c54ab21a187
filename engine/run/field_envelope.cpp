#include "engine/run/field_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/cable.h"
#include "engine/run/cable_field.h"

namespace plumb {
namespace {

constexpr int most_in_element = 33, enough_in_all = 500;

// Just inside of an element, so that rounding does not take its end for the start of the next.
constexpr double inset = 1e-9;

std::vector<std::size_t> finite_outputs(const Trajectory& trajectory) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < trajectory.times.size(); ++k)
    if (trajectory.q[k].allFinite() && trajectory.v[k].allFinite()) result.push_back(k);
  return result;
}

// The weights of the trapezoidal rule; of a single output, 1.
std::vector<double> time_weights(const std::vector<double>& times, const std::vector<std::size_t>& outputs) {
  std::vector<double> weights(outputs.size(), outputs.size() == 1 ? 1 : 0);
  for (std::size_t k = 1; k < outputs.size(); ++k) {
    const double half = (times[outputs[k]] - times[outputs[k - 1]]) / 2;
    weights[k - 1] += half;
    weights[k] += half;
  }
  return weights;
}

}  // namespace

FieldEnvelope field_envelope(const Cable& cable, ColorField field, const Trajectory& trajectory) {
  const int elements = cable.elements();
  const int in_element = std::clamp(enough_in_all / elements, 2, most_in_element);
  FieldEnvelope result;
  std::vector<double> fractions;
  for (int e = 0; e < elements; ++e)
    for (int k = 0; k < in_element; ++k) {
      const double x = static_cast<double>(k) / (in_element - 1);
      result.places.push_back((e + x) / elements * cable.length());
      fractions.push_back((e + std::clamp(x, inset, 1 - inset)) / elements);
    }
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = fractions.size();
  result.least.assign(count, none);
  result.greatest.assign(count, none);
  result.mean.assign(count, 0);
  result.peak = -std::numeric_limits<double>::infinity();
  std::vector<double> weight(count, 0);
  const std::vector<std::size_t> outputs = finite_outputs(trajectory);
  const std::vector<double> weights = time_weights(trajectory.times, outputs);
  for (std::size_t n = 0; n < outputs.size(); ++n) {
    const std::size_t output = outputs[n];
    for (std::size_t i = 0; i < count; ++i) {
      const double value =
          field_value(cable, field, trajectory.q[output], trajectory.v[output], fractions[i]);
      if (!std::isfinite(value)) continue;
      // fmin and fmax leave out what is not a number.
      result.least[i] = std::fmin(result.least[i], value);
      result.greatest[i] = std::fmax(result.greatest[i], value);
      result.mean[i] += weights[n] * value;
      weight[i] += weights[n];
      if (value <= result.peak) continue;
      result.peak = value;
      result.peak_place = result.places[i];
      result.peak_time = trajectory.times[output];
    }
  }
  for (std::size_t i = 0; i < count; ++i) result.mean[i] = weight[i] > 0 ? result.mean[i] / weight[i] : none;
  return result;
}

}  // namespace plumb
