#pragma once

#include <string_view>
#include <vector>

namespace plumb {

/// Numbers known at some times only, between them by the polynomial through the four times about, or through
/// all where there are fewer; never outside them. Keeps references: both lists must outlive it.
class TimeInterpolation {
 public:
  /// `times` strictly increasing, one or more, and as many `values`.
  TimeInterpolation(const std::vector<double>& times, const std::vector<double>& values)
      : times_(times), values_(values) {}

  /// At a time within the first and the last. At one of its own the number itself.
  double value(double t) const;
  /// The derivative of the same polynomial by time; 0 of a single number.
  double rate(double t) const;

 private:
  const std::vector<double>& times_;
  const std::vector<double>& values_;
};

/// How numbers at `count` times are interpolated: "linearly", "quadratically", "cubically".
std::string_view interpolation_in_words(std::size_t count);

}  // namespace plumb
