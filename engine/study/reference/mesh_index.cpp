#include "engine/study/reference/mesh_index.h"

#include <algorithm>
#include <cmath>

#include "engine/study/reference/grid_convergence.h"

namespace plumb {
namespace {

constexpr double mesh_ratio = 2;

std::vector<double> greatest_changes(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> changes(a.size());
  double greatest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double change = std::abs(a[k] - b[k]);
    // What is not a number stays one.
    greatest = std::isnan(change) ? change : change > greatest ? change : greatest;
    changes[k] = greatest;
  }
  return changes;
}

}  // namespace

bool is_possible_order(double order) {
  return order >= least_possible_order && order <= greatest_possible_order;
}

MeshIndex mesh_index(const std::vector<double>& fine, const std::vector<double>& medium,
                     const std::vector<double>& coarse, OfThree of) {
  MeshIndex result;
  if (fine.empty()) return result;
  const std::vector<double> change21 = greatest_changes(fine, medium);
  const std::vector<double> change32 = greatest_changes(medium, coarse);
  result.order =
      grid_convergence(change21.back(), change32.back(), mesh_ratio, mesh_ratio, certain_factor).order;
  if (!is_possible_order(result.order)) return result;
  const double growth = std::pow(mesh_ratio, std::min(result.order, mesh_order));
  for (std::size_t k = 0; k < fine.size(); ++k) {
    const double error =
        of == OfThree::finest ? change21[k] / (growth - 1) : change32[k] * growth / (growth - 1);
    result.values.push_back(certain_factor * error);
  }
  return result;
}

std::vector<double> two_run_index(const std::vector<double>& run, const std::vector<double>& finer,
                                  double ratio, double order) {
  const double growth = std::pow(ratio, order);
  std::vector<double> index = greatest_changes(run, finer);
  for (double& value : index) value *= uncertain_factor * growth / (growth - 1);
  return index;
}

std::vector<double> two_run_bound(const std::vector<double>& run, const std::vector<double>& other) {
  std::vector<double> bound = greatest_changes(run, other);
  for (double& value : bound) value *= uncertain_factor;
  return bound;
}

}  // namespace plumb
