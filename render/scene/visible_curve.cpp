#include "render/scene/visible_curve.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

/// Spans that are looked into however straight they seem: a whole wave could hide in a wider one.
constexpr int first_spans = 32;
/// Halvings of an element beyond which nothing is gained.
constexpr double finest = 1.0 / 64;

double distance_to_chord(const Point& p, const Point& a, const Point& b) {
  const Point chord = b - a;
  const double length = chord.squaredNorm();
  const double along = length > 0 ? std::clamp((p - a).dot(chord) / length, 0.0, 1.0) : 0;
  return (p - a - along * chord).norm();
}

class Subdivision {
 public:
  Subdivision(const Motion& motion, const Eigen::VectorXd& state, const Camera& camera, double tolerance,
              double longest)
      : motion_(motion), state_(state), camera_(camera), tolerance_(tolerance), longest_(longest) {}

  std::vector<CurvePoint> points() {
    const double elements = motion_.elements();
    // Elements are cut in the same places where they are few, and taken several at once where they are many.
    const double spans = elements >= first_spans ? first_spans : elements * std::ceil(first_spans / elements);
    result_.push_back(motion_.point(state_, 0));
    for (double k = 0; k < spans; ++k)
      add(elements * k / spans, result_.back(), elements * (k + 1) / spans,
          motion_.point(state_, elements * (k + 1) / spans));
    return std::move(result_);
  }

 private:
  /// Adds what lies between two places, and the second one; places count elements from the first end.
  void add(double from, const CurvePoint& first, double to, const CurvePoint& last) {
    const double middle = (from + to) / 2;
    const CurvePoint half = motion_.point(state_, middle);
    if (to - from > longest_ || (to - from > finest && is_bent(from, first, middle, half, to, last))) {
      add(from, first, middle, half);
      add(middle, half, to, last);
    } else {
      result_.push_back(last);
    }
  }

  bool is_bent(double from, const CurvePoint& first, double middle, const CurvePoint& half, double to,
               const CurvePoint& last) const {
    const Point a = camera_.pixel(first.position), b = camera_.pixel(last.position);
    const auto off = [&](const CurvePoint& point) {
      const Point p = camera_.pixel(point.position);
      // What is not seen needs no detail.
      return p.allFinite() && a.allFinite() && b.allFinite() && distance_to_chord(p, a, b) > tolerance_;
    };
    return off(half) || off(motion_.point(state_, (from + middle) / 2)) ||
           off(motion_.point(state_, (middle + to) / 2));
  }

  const Motion& motion_;
  const Eigen::VectorXd& state_;
  const Camera& camera_;
  double tolerance_;
  double longest_;
  std::vector<CurvePoint> result_;
};

}  // namespace

std::vector<CurvePoint> visible_curve(const Motion& motion, const Eigen::VectorXd& state,
                                      const Camera& camera, double tolerance, double longest) {
  return Subdivision(motion, state, camera, tolerance, longest).points();
}

}  // namespace plumb
