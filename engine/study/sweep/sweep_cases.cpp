#include "engine/study/sweep/sweep_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "engine/base/random_draw.h"
#include "engine/case/case_words.h"
#include "engine/integrate/method_info.h"

namespace plumb {
namespace {

/// Short enough to be read, and the value that the case reader will have.
std::string in_short(double value) {
  return fmt::format("{:.6g}", value);
}

template <class Word>
std::string set(const char* key, const Word& value) {
  return fmt::format("{}={}", key, value);
}

/// 2/ω of the fastest wave through one element, axial (9.55 c/l for the straight cable) or bending
/// (√8400 c_b/l² of a free element): a step that the leapfrog can just take.
double explicit_limit(const CableSpec& cable) {
  const double l = cable.length / cable.elements;
  const double axial = 9.55 * std::sqrt(cable.youngs_modulus / cable.density) / l;
  const double bending =
      std::sqrt(8400 * cable.youngs_modulus * cable.second_moment / (cable.density * cable.area)) / (l * l);
  return 2 / std::max(axial, bending);
}

double drawn(RandomDraw& draw, const MethodParameter& parameter) {
  constexpr double wide = 100;
  const bool ratio = parameter.minimum > 0 && parameter.maximum / parameter.minimum >= wide;
  double value = ratio             ? draw.of_equal_ratio(parameter.minimum, parameter.maximum)
                 : parameter.whole ? draw.uniform(parameter.minimum - 0.5, parameter.maximum + 0.5)
                                   : draw.uniform(parameter.minimum, parameter.maximum);
  value = parameter.whole ? std::round(value) : std::strtod(in_short(value).c_str(), nullptr);
  // Not -0, which would be written so.
  return std::clamp(value, parameter.minimum, parameter.maximum) + 0.0;
}

std::vector<const MethodInfo*> methods_in_time(const Case& spec) {
  std::vector<const MethodInfo*> methods;
  for (const MethodInfo& info : method_infos())
    if (info.dynamic && takes(info, spec)) methods.push_back(&info);
  return methods;
}

/// Draws what acts on a cable and what moves it.
class DrawnLoads {
 public:
  DrawnLoads(const Case& file_case, long seed, long model, double end, Support first, Support last)
      : file_(file_case), draw_(RandomDraw::Of::loads, seed, model), end_(end), first_(first), last_(last) {}

  std::vector<std::string> overrides() {
    std::vector<std::string> result;
    const bool loads = wanted(), mass = wanted(), damping = wanted(), motion = wanted();
    if (loads && file_.loads.applied.empty()) result.push_back(this->loads());
    if (mass && file_.masses.empty()) {
      const double at = draw_.share(), size = draw_.of_equal_ratio(0.1, 10) * mass_of_cable();
      result.push_back(fmt::format("mass=[{{at={:.3g}, mass={:.3g}}}]", at, size));
    }
    if (damping && file_.damping == DampingSpec{}) {
      if (draw_.coin())
        result.push_back(fmt::format("damping.mass={:.3g}", draw_.of_equal_ratio(0.1, 10) / end_));
      // Up to aperiodic decay of the fastest wave.
      else
        result.push_back(fmt::format("damping.material={:.3g}",
                                     draw_.of_equal_ratio(1e-3, 1) * explicit_limit(file_.cable)));
    }
    if (motion && !file_.supports.move()) add_motion(result);
    return result;
  }

 private:
  bool wanted() { return draw_.share() < 1.0 / 3; }

  double mass_of_cable() const { return file_.cable.density * file_.cable.area * file_.cable.length; }

  /// Of the weight, or what a swing within the run takes where there is none.
  double weight() const {
    const double gravity = file_.loads.gravity.norm();
    return mass_of_cable() * (gravity > 0 ? gravity : file_.cable.length / (end_ * end_));
  }

  Vec3 any_direction() {
    Vec3 result;
    for (double& x : result) x = draw_.uniform(-1, 1);
    return result;
  }

  std::string in_time(double most) {
    const double size = draw_.uniform(-most, most), phase = draw_.uniform(1, 12) / end_;
    return draw_.coin() ? fmt::format("{:.3g}*sin({:.3g}*t)", size, phase)
                        : fmt::format("{:.3g}*(1-cos({:.3g}*t))", size, phase);
  }

  std::string loads() {
    std::string list;
    for (int left = draw_.coin() ? 1 : 2; left > 0; --left) {
      LoadKind kind = draw_.one_of(words_of<LoadKind>).value;
      const bool follows = draw_.coin();
      const double size = draw_.of_equal_ratio(0.1, 3) * weight(), at = draw_.share();
      const std::string factor = draw_.coin() ? "1" : in_time(1);
      Vec3 value = size * any_direction();
      Eigen::Index across = 0;
      const double along = file_.start.direction.cwiseAbs().minCoeff(&across);
      // A moment is across the cable, to the last digit, and bends it to some arc: one of the size of the
      // weight times the length would crumple it in a way that no two methods agree on.
      const double bent = file_.cable.youngs_modulus * file_.cable.second_moment / file_.cable.length;
      if (kind == LoadKind::moment && (along != 0 || bent == 0)) kind = LoadKind::force;
      if (kind == LoadKind::moment) value = value.norm() / weight() * bent * Vec3::Unit(across);
      if (kind == LoadKind::distributed) value /= file_.cable.length;
      list += fmt::format("{}{{kind=\"{}\", {}value=[{:.3g}, {:.3g}, {:.3g}], follows={}, factor=\"{}\"}}",
                          list.empty() ? "" : ", ", word(kind),
                          kind == LoadKind::distributed ? "" : fmt::format("at={:.3g}, ", at), value.x(),
                          value.y(), value.z(), follows, factor);
    }
    return "load=[" + list + "]";
  }

  void add_motion(std::vector<std::string>& result) {
    const double way = draw_.of_equal_ratio(0.003, 0.1) * file_.cable.length;
    const auto motion = [&](const char* key) {
      const std::array along{in_time(way), in_time(way), in_time(way)};
      result.push_back(
          fmt::format("supports.{}={{ x=\"{}\", y=\"{}\", z=\"{}\" }}", key, along[0], along[1], along[2]));
    };
    const bool goes = draw_.coin(), other_goes = draw_.coin();
    if (first_ != Support::free && (goes || last_ == Support::free)) motion("first_motion");
    if (last_ != Support::free && other_goes) motion("last_motion");
    if (first_ != Support::clamped || last_ == Support::clamped || draw_.coin()) return;
    const Vec3 axis = any_direction();
    const std::string angle = in_time(2);
    result.push_back(fmt::format("supports.first_rotation={{ axis=[{:.3g}, {:.3g}, {:.3g}], angle=\"{}\" }}",
                                 axis.x(), axis.y(), axis.z(), angle));
  }

  const Case& file_;
  RandomDraw draw_;
  double end_;  // s
  Support first_, last_;
};

}  // namespace

std::vector<std::string> model_overrides(const Case& file_case, long seed, long model) {
  constexpr double most_elements = 16, shortest = 0.05, longest = 0.5, greatest_f = 20;
  constexpr int outputs = 20;
  constexpr std::array strains{StrainModel::green_geometric, StrainModel::engineering_material};
  constexpr std::array rules{QuadratureRule::full, QuadratureRule::reduced};
  constexpr std::array rates{SlopeRates::rigid, SlopeRates::zero};
  RandomDraw draw(RandomDraw::Of::model, seed, model);
  const double end = draw.of_equal_ratio(shortest, longest);
  const std::string interval = fmt::format("{:.4g}", end / outputs);
  std::vector<std::string> result;
  const double f = draw.of_equal_ratio(1, greatest_f);
  if (file_case.parameters.contains("f")) result.push_back(set("parameters.f", in_short(f)));
  result.push_back(
      set("cable.elements", static_cast<int>(std::floor(draw.of_equal_ratio(1, most_elements + 1)))));
  result.push_back(set("cable.strain", word(draw.one_of(strains))));
  result.push_back(set("cable.quadrature", word(draw.one_of(rules))));
  const Support first = draw.one_of(words_of<Support>).value, last = draw.one_of(words_of<Support>).value;
  result.push_back(set("supports.first", word(first)));
  result.push_back(set("supports.last", word(last)));
  result.push_back(set("start.slope_rates", word(draw.one_of(rates))));
  result.push_back(set("time.output_interval", interval));
  result.push_back(set("time.end", in_short(outputs * std::strtod(interval.c_str(), nullptr))));
  for (std::string& text : DrawnLoads(file_case, seed, model, end, first, last).overrides())
    result.push_back(std::move(text));
  return result;
}

std::vector<std::string> method_overrides(const Case& file_case, const Case& model, long seed, long number) {
  constexpr double below_limit = 20, loosest = 0.3, tightest = 1e-11;
  RandomDraw draw(RandomDraw::Of::method, seed, number);
  const MethodInfo& info = *draw.one_of(methods_in_time(model));
  std::vector<std::string> result{set("method.name", info.name)};
  bool fixed_step = info.takes_step && (!info.takes_tolerances || draw.coin());
  if (info.name == file_case.method.name) fixed_step = file_case.method.step.has_value();
  if (fixed_step) {
    const double end = model.time.end;
    const double least = std::min(explicit_limit(model.cable) / below_limit, end);
    const double step = std::strtod(in_short(draw.of_equal_ratio(least, end)).c_str(), nullptr);
    result.push_back(set("method.step", in_short(std::min(step, end))));
  } else {
    result.push_back(set("method.rtol", in_short(draw.of_equal_ratio(tightest, loosest))));
    if (draw.coin()) result.push_back(set("method.atol", in_short(draw.of_equal_ratio(tightest, loosest))));
  }
  for (const MethodParameter& parameter : info.parameters) {
    const double value = drawn(draw, parameter);
    if (draw.coin()) result.push_back(set(("method." + parameter.name).c_str(), value));
  }
  return result;
}

}  // namespace plumb
