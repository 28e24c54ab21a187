#include "engine/model/chain.h"

#include <algorithm>

#include "engine/kernels/element_mass.h"

namespace plumb {

Chain::Chain(const ElementConstants& constants)
    : length_(constants.length),
      half_mass_(ElementMass(constants).rr),
      slope_mass_(ElementMass(constants).gg),
      link_(constants.axial_stiffness, constants.length,
            constants.green ? StrainModel::green_geometric : StrainModel::engineering_material) {}

Vec3 Chain::chord(const Eigen::VectorXd& nodal, Eigen::Index link) const {
  return nodal.segment<3>(6 * link + 6) - nodal.segment<3>(6 * link);
}

std::optional<int> Chain::subtract_gradient(const Eigen::VectorXd& q, Eigen::VectorXd& f) const {
  std::optional<int> collapsed;
  for (Eigen::Index k = 0; 6 * k + 6 < q.size(); ++k) {
    const Vec3 d = chord(q, k);
    if (!link_.is_whole(d)) {
      if (!collapsed) collapsed = static_cast<int>(k);
      continue;
    }
    const Vec3 pull = link_.gradient(d);
    f.segment<3>(6 * k) += pull;
    f.segment<3>(6 * k + 6) -= pull;
  }
  return collapsed;
}

void Chain::system(const Eigen::VectorXd& q, double mass_factor, double stiffness_factor,
                   BlockTridiagonal& A) const {
  const int last = A.nodes() - 1;
  for (int node = 0; node <= last; ++node) {
    const double halves = node == 0 || node == last ? 1 : 2;
    A.diagonal(node).setZero();
    A.diagonal(node).diagonal().head<3>().setConstant(mass_factor * halves * half_mass_);
    A.diagonal(node).diagonal().tail<3>().setConstant(mass_factor * halves * slope_mass_);
    A.below(node).setZero();
  }
  if (stiffness_factor == 0) return;
  for (int k = 0; k < last; ++k) {
    const Vec3 d = chord(q, k);
    // The force has told that the link collapsed; there is no tangent to give.
    if (!link_.is_whole(d)) continue;
    const Eigen::Matrix3d K = stiffness_factor * link_.tangent(d);
    A.diagonal(k).topLeftCorner<3, 3>() += K;
    A.below(k).topLeftCorner<3, 3>() -= K;
    A.diagonal(k + 1).topLeftCorner<3, 3>() += K;
  }
}

double Chain::strain_energy(const Eigen::VectorXd& q) const {
  double sum = 0;
  for (Eigen::Index k = 0; 6 * k + 6 < q.size(); ++k) sum += link_.energy(chord(q, k));
  return sum;
}

double Chain::kinetic_energy(const Eigen::VectorXd& v) const {
  double sum = 0;
  for (Eigen::Index k = 0; 6 * k + 6 < v.size(); ++k)
    sum += v.segment<3>(6 * k).squaredNorm() + v.segment<3>(6 * k + 6).squaredNorm();
  return 0.5 * half_mass_ * sum;
}

void Chain::set_slopes(Eigen::VectorXd& nodal) const {
  const Eigen::Index links = nodal.size() / 6 - 1;
  for (Eigen::Index node = 0; node <= links; ++node) {
    const Eigen::Index before = std::max<Eigen::Index>(node - 1, 0), after = std::min(node, links - 1);
    nodal.segment<3>(6 * node + 3) = (chord(nodal, before) + chord(nodal, after)) / (2 * length_);
  }
}

}  // namespace plumb
