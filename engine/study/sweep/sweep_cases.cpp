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
  result.push_back(set("supports.first", draw.one_of(words_of<Support>).word));
  result.push_back(set("supports.last", draw.one_of(words_of<Support>).word));
  result.push_back(set("start.slope_rates", word(draw.one_of(rates))));
  result.push_back(set("time.output_interval", interval));
  result.push_back(set("time.end", in_short(outputs * std::strtod(interval.c_str(), nullptr))));
  return result;
}

std::vector<std::string> method_overrides(const Case& file_case, const Case& model, long seed, long number) {
  constexpr double below_limit = 20, loosest = 0.3, tightest = 1e-11;
  RandomDraw draw(RandomDraw::Of::method, seed, number);
  const MethodInfo& info = *draw.one_of(methods_in_time(file_case));
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
