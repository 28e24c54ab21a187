#include "engine/case/column_quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/time_interpolation.h"

namespace plumb {
namespace {

struct AggregateWord {
  ColumnQuantity::Of of;
  std::string_view word;
};

constexpr std::array<AggregateWord, 5> aggregate_table{{
    {ColumnQuantity::Of::greatest, "greatest"},
    {ColumnQuantity::Of::least, "least"},
    {ColumnQuantity::Of::time_of_greatest, "time of greatest"},
    {ColumnQuantity::Of::time_of_least, "time of least"},
    {ColumnQuantity::Of::period, "period"},
}};

/// A column from its first time to some other.
class Passage {
 public:
  Passage(const std::vector<double>& times, const std::vector<double>& values, double until,
          bool known_between)
      : times_(times), values_(values), known_between_(known_between), between_(times, values) {
    while (count_ < times.size() && times[count_] <= until) ++count_;
    end_ = std::min(until, times.back());
    // Where nothing is known between, it ends with a time of its own.
    if (!known_between && count_ > 0) end_ = times[count_ - 1];
  }

  bool is_finite() const {
    return count_ > 0 && std::all_of(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(count_),
                                     [](double x) { return std::isfinite(x); });
  }

  double last() const { return between_.value(end_); }

  struct Extreme {
    double value, time;
  };
  /// The greatest of sign times the values.
  Extreme extreme(double sign) const {
    Extreme found{values_.front(), times_.front()};
    const auto offer = [&](double t) {
      const double value = between_.value(t);
      if (sign * value > sign * found.value) found = {value, t};
    };
    each_gap([&](double from, double to) {
      if (known_between_)
        for (const double t : turning_points(from, to)) offer(t);
      offer(to);
    });
    return found;
  }

  /// When the values rise through a level.
  std::vector<double> rises_through(double level) const {
    constexpr int halvings = 60;
    std::vector<double> rises;
    each_gap([&](double from, double to) {
      if (!(between_.value(from) < level && between_.value(to) >= level)) return;
      for (int k = 0; k < halvings; ++k) {
        const double middle = (from + to) / 2;
        (between_.value(middle) < level ? from : to) = middle;
      }
      rises.push_back(to);
    });
    return rises;
  }

 private:
  void each_gap(const auto& visit) const {
    for (std::size_t k = 0; k + 1 < times_.size() && times_[k] < end_; ++k)
      visit(times_[k], std::min(times_[k + 1], end_));
  }

  /// Where the cubic between two times is level: its rate is a quadratic, c + b u + a u², of the share of the
  /// gap from its middle.
  std::vector<double> turning_points(double from, double to) const {
    constexpr double apart = 1.0 / 3;
    const double middle = (from + to) / 2, gap = to - from;
    const double before = between_.rate(middle - apart * gap), c = between_.rate(middle),
                 after = between_.rate(middle + apart * gap);
    const double b = (after - before) / (2 * apart), a = (after + before - 2 * c) / (2 * apart * apart);
    const double root = -(b + std::copysign(std::sqrt(b * b - 4 * a * c), b)) / 2;
    std::vector<double> points;
    // What is not a number or beyond the gap is no turning point of it.
    for (const double u : {root / a, c / root})
      if (std::abs(u) < 0.5) points.push_back(middle + u * gap);
    return points;
  }

  const std::vector<double>&times_, &values_;
  bool known_between_;
  TimeInterpolation between_;
  std::size_t count_ = 0;  // of the times that it has
  double end_ = 0;
};

}  // namespace

ColumnQuantity column_quantity(const std::string& quantity) {
  for (const auto& [of, word] : aggregate_table)
    if (quantity.starts_with(std::string(word) + ' ')) return {of, quantity.substr(word.size() + 1)};
  return {ColumnQuantity::Of::last, quantity};
}

std::string aggregate_words() {
  std::string words;
  for (const auto& [of, word] : aggregate_table)
    words += fmt::format("{}{}", words.empty() ? "" : ", ", word);
  return words;
}

std::optional<std::string_view> unit(const ColumnQuantity& quantity, const ProbeColumns& columns) {
  const std::optional<std::string_view> of_column = columns.unit(quantity.column);
  const bool is_time = quantity.of == ColumnQuantity::Of::time_of_greatest ||
                       quantity.of == ColumnQuantity::Of::time_of_least ||
                       quantity.of == ColumnQuantity::Of::period;
  return of_column && is_time ? "s" : of_column;
}

ColumnNumber column_number(ColumnQuantity::Of of, const std::vector<double>& times,
                           const std::vector<double>& values, double until, bool known_between) {
  const Passage passage(times, values, until, known_between);
  ColumnNumber number;
  if (!passage.is_finite()) {
    number.fault = fmt::format("no finite numbers up to {:.4g} s", until);
    return number;
  }
  switch (of) {
    case ColumnQuantity::Of::last:
      number.value = passage.last();
      break;
    case ColumnQuantity::Of::greatest:
      number.value = passage.extreme(1).value;
      break;
    case ColumnQuantity::Of::least:
      number.value = passage.extreme(-1).value;
      break;
    case ColumnQuantity::Of::time_of_greatest:
      number.value = passage.extreme(1).time;
      break;
    case ColumnQuantity::Of::time_of_least:
      number.value = passage.extreme(-1).time;
      break;
    case ColumnQuantity::Of::period: {
      const double middle = (passage.extreme(1).value + passage.extreme(-1).value) / 2;
      const std::vector<double> rises = passage.rises_through(middle);
      if (rises.size() < 2)
        number.fault =
            fmt::format("up to {:.4g} s it rises through the middle of its range {}, and a period takes two",
                        until, rises.empty() ? "never" : "once");
      else
        number.value = (rises.back() - rises.front()) / static_cast<double>(rises.size() - 1);
      break;
    }
  }
  return number;
}

}  // namespace plumb
