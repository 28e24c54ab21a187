#include "engine/case/case.h"

#include "engine/case/case_words.h"

namespace plumb {
namespace {

template <class E>
std::string_view word_for(E value) {
  for (const auto& entry : words_of<E>) {
    if (entry.value == value) return entry.word;
  }
  return "";
}

}  // namespace

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;
bool Case::operator==(const Case&) const = default;

std::string_view word(CableModel value) {
  return word_for(value);
}
std::string_view word(StrainModel value) {
  return word_for(value);
}
std::string_view word(QuadratureRule value) {
  return word_for(value);
}
std::string_view word(Support value) {
  return word_for(value);
}
std::string_view word(SlopeRates value) {
  return word_for(value);
}
std::string_view word(LoadKind value) {
  return word_for(value);
}
std::string_view word(Quantity value) {
  return word_for(value);
}
std::string_view word(Norm value) {
  return word_for(value);
}

std::string_view unit(Quantity quantity) {
  switch (quantity) {
    case Quantity::position:
    case Quantity::relative_position:
      return "m";
    case Quantity::velocity:
      return "m/s";
    case Quantity::slope:
      return "1";
    case Quantity::axial_strain:
      return "1";
    case Quantity::axial_force:
      return "N";
    case Quantity::curvature:
      return "1/m";
    case Quantity::bending_moment:
      return "N m";
  }
  return "";
}

bool is_vector(Quantity quantity) {
  return quantity == Quantity::position || quantity == Quantity::relative_position ||
         quantity == Quantity::velocity || quantity == Quantity::slope;
}

std::vector<std::string> column_names(const ProbeSpec& probe) {
  if (!is_vector(probe.quantity)) return {probe.name};
  return {probe.name + ".x", probe.name + ".y", probe.name + ".z"};
}

}  // namespace plumb
