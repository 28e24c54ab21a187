#pragma once

#include <array>
#include <string_view>

#include "engine/case/case.h"

namespace plumb {

/// A value of an enumeration beside the word that case files use for it.
template <class E>
struct Word {
  E value;
  std::string_view word;
};

/// All the words of an enumeration: `words_of<Norm>`.
template <class E>
inline constexpr std::array<Word<E>, 0> words_of{};

template <>
inline constexpr std::array words_of<CableModel>{
    Word<CableModel>{CableModel::cable, "cable"},
    Word<CableModel>{CableModel::chain, "chain"},
    Word<CableModel>{CableModel::rigid, "rigid"},
};

template <>
inline constexpr std::array words_of<StrainModel>{
    Word<StrainModel>{StrainModel::green_geometric, "green-geometric"},
    Word<StrainModel>{StrainModel::engineering_material, "engineering-material"},
};

template <>
inline constexpr std::array words_of<QuadratureRule>{
    Word<QuadratureRule>{QuadratureRule::full, "full"},
    Word<QuadratureRule>{QuadratureRule::reduced, "reduced"},
};

template <>
inline constexpr std::array words_of<Support>{
    Word<Support>{Support::free, "free"},
    Word<Support>{Support::pinned, "pinned"},
    Word<Support>{Support::clamped, "clamped"},
};

template <>
inline constexpr std::array words_of<SlopeRates>{
    Word<SlopeRates>{SlopeRates::rigid, "rigid"},
    Word<SlopeRates>{SlopeRates::zero, "zero"},
};

template <>
inline constexpr std::array words_of<LoadKind>{
    Word<LoadKind>{LoadKind::force, "force"},
    Word<LoadKind>{LoadKind::moment, "moment"},
    Word<LoadKind>{LoadKind::distributed, "distributed"},
};

template <>
inline constexpr std::array words_of<Quantity>{
    Word<Quantity>{Quantity::position, "position"},
    Word<Quantity>{Quantity::relative_position, "relative-position"},
    Word<Quantity>{Quantity::velocity, "velocity"},
    Word<Quantity>{Quantity::slope, "slope"},
    Word<Quantity>{Quantity::axial_strain, "axial-strain"},
    Word<Quantity>{Quantity::axial_force, "axial-force"},
    Word<Quantity>{Quantity::curvature, "curvature"},
    Word<Quantity>{Quantity::bending_moment, "bending-moment"},
};

template <>
inline constexpr std::array words_of<Norm>{
    Word<Norm>{Norm::max, "max"},
    Word<Norm>{Norm::rms, "rms"},
};

template <>
inline constexpr std::array words_of<View>{
    Word<View>{View::fit, "fit"},       Word<View>{View::front, "front"}, Word<View>{View::back, "back"},
    Word<View>{View::left, "left"},     Word<View>{View::right, "right"}, Word<View>{View::top, "top"},
    Word<View>{View::bottom, "bottom"}, Word<View>{View::orbit, "orbit"}, Word<View>{View::follow, "follow"},
};

template <>
inline constexpr std::array words_of<SceneTheme>{
    Word<SceneTheme>{SceneTheme::light, "light"},
    Word<SceneTheme>{SceneTheme::dark, "dark"},
};

template <>
inline constexpr std::array words_of<SceneBackground>{
    Word<SceneBackground>{SceneBackground::scene, "scene"},
    Word<SceneBackground>{SceneBackground::plain, "plain"},
    Word<SceneBackground>{SceneBackground::transparent, "transparent"},
};

template <>
inline constexpr std::array words_of<ColorField>{
    Word<ColorField>{ColorField::none, "none"},
    Word<ColorField>{ColorField::axial_strain, "axial-strain"},
    Word<ColorField>{ColorField::axial_force, "axial-force"},
    Word<ColorField>{ColorField::curvature, "curvature"},
    Word<ColorField>{ColorField::bending_moment, "bending-moment"},
    Word<ColorField>{ColorField::speed, "speed"},
};

}  // namespace plumb
