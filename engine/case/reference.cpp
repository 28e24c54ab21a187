#include "engine/case/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {

std::string_view word(Abscissa abscissa) {
  switch (abscissa) {
    case Abscissa::time:
      return "t";
    case Abscissa::mode:
      return "mode";
    case Abscissa::load:
      return "load";
  }
  return "t";
}

bool SharedErrors::has_mesh_of(const CableSpec& cable) const {
  return elements == cable.elements && strain == cable.strain && quadrature == cable.quadrature;
}

bool SharedErrors::has_input(const std::string& key) const {
  return std::find(inputs.begin(), inputs.end(), key) != inputs.end();
}

const ReferenceSeries* Reference::find(std::string_view name) const {
  const auto found = std::find_if(series.begin(), series.end(),
                                  [&](const ReferenceSeries& item) { return item.name == name; });
  return found != series.end() ? &*found : nullptr;
}

std::string difference(const ReferenceCable& reference, const CableSpec& cable, const std::string& whose) {
  constexpr double same = 1e-6;
  const struct {
    const char* name;
    const char* unit;
    std::optional<double> stated;
    double actual;
  } items[] = {{"L", "m", reference.length, cable.length},
               {"EA", "N", reference.axial_stiffness, cable.youngs_modulus * cable.area},
               {"EI", "N m²", reference.bending_stiffness, cable.youngs_modulus * cable.second_moment},
               {"ρA", "kg/m", reference.mass_per_length, cable.density * cable.area}};
  std::string text;
  for (const auto& item : items)
    if (item.stated && !(std::abs(item.actual - *item.stated) <= same * *item.stated))
      text += fmt::format("{}{} is {:.6g} {}, that {} {:.6g} {}", text.empty() ? "" : "; ", item.name,
                          item.actual, item.unit, whose, *item.stated, item.unit);
  return text;
}

}  // namespace plumb
