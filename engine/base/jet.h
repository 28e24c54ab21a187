#pragma once

#include <cmath>

namespace plumb {

/// A number that depends on time, with its first two derivatives by it.
struct Jet {
  double value = 0;
  double rate = 0;    ///< 1/s
  double second = 0;  ///< 1/s²
};

/// f(x), given f, f' and f'' at the value of x. A derivative that meets no change does not count, so that an
/// infinite one is none of a constant.
inline Jet chained(const Jet& x, double f, double first, double second) {
  const auto product = [](double derivative, double change) { return change == 0 ? 0 : derivative * change; };
  return {f, product(first, x.rate), product(second, x.rate * x.rate) + product(first, x.second)};
}

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
inline Jet operator-(const Jet& a) {
  return {-a.value, -a.rate, -a.second};
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.second * b.value + 2 * a.rate * b.rate + a.value * b.second};
}
inline Jet operator/(const Jet& a, const Jet& b) {
  const double f = a.value / b.value, rate = (a.rate - f * b.rate) / b.value;
  return {f, rate, (a.second - 2 * rate * b.rate - f * b.second) / b.value};
}

/// aᵇ.
inline Jet pow(const Jet& a, const Jet& b) {
  const double x = a.value, n = b.value, f = std::pow(x, n);
  // The derivatives of a power that is a whole number end at 0, whatever the base.
  const auto power = [&](double factor, double exponent) {
    return factor == 0 ? 0 : factor * std::pow(x, exponent);
  };
  Jet result = chained(a, f, power(n, n - 1), power(n * (n - 1), n - 2));
  if (b.rate == 0 && b.second == 0) return result;
  const double log = std::log(x), by_exponent = f * log;
  const double mixed = std::pow(x, n - 1) * (1 + n * log);
  result.rate += by_exponent * b.rate;
  result.second += by_exponent * (log * b.rate * b.rate + b.second) + 2 * mixed * a.rate * b.rate;
  return result;
}

}  // namespace plumb
