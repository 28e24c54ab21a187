#include "engine/model/quadrature.h"

#include <array>
#include <stdexcept>
#include <string>

namespace plumb {
namespace {

// Nodes ½(1 ± ξ) with ξ = sqrt(1/3); sqrt(3/5); ⅓ sqrt(5 ∓ 2 sqrt(10/7)).
constexpr std::array<QuadraturePoint, 2> gauss_2{
    {{0.21132486540518711775, 0.5}, {0.78867513459481288225, 0.5}}};
constexpr std::array<QuadraturePoint, 3> gauss_3{
    {{0.11270166537925831148, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074168852, 5.0 / 18}}};
constexpr std::array<QuadraturePoint, 5> gauss_5{{{0.04691007703066800360, 0.11846344252809454376},
                                                  {0.23076534494715845448, 0.23931433524968323402},
                                                  {0.5, 64.0 / 225},
                                                  {0.76923465505284154552, 0.23931433524968323402},
                                                  {0.95308992296933199640, 0.11846344252809454376}}};
constexpr std::array<QuadraturePoint, 3> lobatto_3{{{0, 1.0 / 6}, {0.5, 4.0 / 6}, {1, 1.0 / 6}}};

}  // namespace

std::span<const QuadraturePoint> gauss_rule(int points) {
  switch (points) {
    case 2:
      return gauss_2;
    case 3:
      return gauss_3;
    case 5:
      return gauss_5;
    default:
      throw std::invalid_argument("no Gauss rule with " + std::to_string(points) + " points");
  }
}

std::span<const QuadraturePoint> lobatto_rule() {
  return lobatto_3;
}

std::span<const QuadraturePoint> stretching_rule(bool full) {
  return full ? gauss_rule(5) : lobatto_rule();
}

std::span<const QuadraturePoint> bending_rule(bool full) {
  return gauss_rule(full ? 3 : 2);
}

}  // namespace plumb
