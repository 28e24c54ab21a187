#include "engine/study/sensitivity/planned_blunders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/integrate/method_roles.h"
#include "engine/read/model_numbers.h"

namespace plumb {
namespace {

/// g, m/s², as it is written and as it is rounded.
constexpr double usual_gravity = 9.81, rounded_gravity = 9.8;

using Planned = std::vector<PlannedBlunder>;

class Planning {
 public:
  explicit Planning(const Case& spec)
      : spec_(spec), cable_(spec.cable), method_(find_method(spec.method.name)) {}

  Planned of(Blunder kind) const {
    switch (kind) {
      case Blunder::no_bending:
        return one(kind, "no bending", {"cable.second_moment=0"},
                   bends() ? "" : "the cable does not resist bending");
      case Blunder::chain:
        return one(kind, "a chain of springs", {"cable.model=chain"}, only_of_cables());
      case Blunder::strain_model:
        return one(kind, "the other strain model",
                   {fmt::format("cable.strain={}", word(cable_.strain == StrainModel::green_geometric
                                                            ? StrainModel::engineering_material
                                                            : StrainModel::green_geometric))},
                   has_mesh());
      case Blunder::half_mesh:
        return one(kind, "half the mesh", {fmt::format("cable.elements={}", cable_.elements / 2)},
                   cable_.elements < 2 ? "the mesh has one element" : has_mesh());
      case Blunder::double_mesh:
        return one(kind, "twice the mesh", {fmt::format("cable.elements={}", 2 * cable_.elements)},
                   has_mesh());
      case Blunder::lumped_mass:
        return one(kind, "mass lumped on the nodes", {},
                   only_of_cables().empty() ? why_no_mass() : only_of_cables());
      case Blunder::zero_slope_rates:
        return one(kind, "slope rates of zero", {"start.slope_rates=zero"}, why_no_slope_rates());
      case Blunder::first_order:
        return first_order();
      case Blunder::rounded_gravity:
        return gravity();
      case Blunder::density_unit:
        if (!why_no_mass().empty()) return one(kind, "a density by a factor of 1000", {}, why_no_mass());
        return {{kind, "a density 1000 times as large", scaled(spec_, "cable.density", 1000)},
                {kind, "a density of a thousandth", scaled(spec_, "cable.density", 1e-3)}};
      case Blunder::other_sign:
        return signs();
      case Blunder::late_output:
        return one(kind, "one output late", {}, timeless() ? "there are no outputs over time" : "");
    }
    return {};
  }

 private:
  static Planned one(Blunder kind, std::string name, std::vector<std::string> overrides,
                     std::string why_not) {
    if (!why_not.empty()) overrides.clear();
    return {{kind, std::move(name), std::move(overrides), std::move(why_not)}};
  }

  bool bends() const { return cable_.model == CableModel::cable && cable_.second_moment > 0; }
  bool timeless() const { return method_ != nullptr && method_->timeless; }
  std::string only_of_cables() const {
    return cable_.model == CableModel::cable ? "" : fmt::format("it is a {}", word(cable_.model));
  }
  std::string has_mesh() const {
    return cable_.model == CableModel::rigid ? "a rigid rod has neither mesh nor strain" : "";
  }
  std::string no_motion() const {
    return method_ != nullptr && !method_->dynamic ? fmt::format("{} integrates no motion", method_->name)
                                                   : "";
  }

  std::string why_no_mass() const {
    const bool rests = method_ != nullptr && !method_->dynamic && !method_->timeless;
    return rests && spec_.loads.gravity.isZero(0) ? "nothing moves, and nothing has weight" : "";
  }

  std::string why_no_slope_rates() const {
    if (const std::string why = no_motion(); !why.empty()) return why;
    if (cable_.model != CableModel::cable) return "slopes follow the nodes";
    if (spec_.start.slope_rates == SlopeRates::zero) return "they are zero";
    return spec_.start.angular_velocity.isZero(0) && spec_.start.axial_speed == 0 ? "it starts from rest"
                                                                                  : "";
  }

  Planned first_order() const {
    constexpr double steps = 2000;
    const MethodInfo& info = first_order_implicit();
    const double step = std::min(spec_.method.step.value_or(spec_.time.end), spec_.time.end / steps);
    std::string why_not = no_motion();
    if (cable_.model == CableModel::rigid) why_not = has_mesh();
    if (method_ != nullptr && method_->order == info.order) why_not = "so is the method of the case";
    return one(Blunder::first_order, fmt::format("an integrator of first order (step {:.3g} s)", step),
               {"method.name=" + info.name, fmt::format("method.step={}", step)}, why_not);
  }

  Planned gravity() const {
    const double size = spec_.loads.gravity.norm();
    constexpr double near = 0.02;
    const double other = std::abs(size - rounded_gravity) < 1e-9 ? usual_gravity : rounded_gravity;
    std::string why_not;
    if (size == 0)
      why_not = "there is no gravity";
    else if (std::abs(size - usual_gravity) > near)
      why_not = fmt::format("gravity is {:.6g} m/s²", size);
    const Vec3 changed = other * (spec_.loads.gravity / (size > 0 ? size : 1));
    return one(Blunder::rounded_gravity, fmt::format("gravity of {:g} m/s²", other),
               {set_vector("loads.gravity", changed)}, why_not);
  }

  Planned signs() const {
    Planned all;
    const auto turned = [&](const char* key, const char* name, const Vec3& value) {
      if (!value.isZero(0))
        all.push_back(
            {Blunder::other_sign, fmt::format("{} the other way", name), {set_vector(key, -value)}});
    };
    turned("loads.gravity", "gravity", spec_.loads.gravity);
    turned("loads.end_force", "the end force", spec_.loads.end_force);
    for (const ModelNumber& number : model_numbers(spec_))
      if (number.key.starts_with("load."))
        all.push_back({Blunder::other_sign, number.words + " the other way", scaled(spec_, number.key, -1)});
    if (all.empty()) all.push_back({Blunder::other_sign, "a load the other way", {}, "there is no load"});
    return all;
  }

  const Case& spec_;
  const CableSpec& cable_;
  const MethodInfo* method_;
};

}  // namespace

std::vector<PlannedBlunder> planned_blunders(const Case& spec, const std::vector<Blunder>& kinds) {
  const Planning planning(spec);
  Planned all;
  for (const Blunder kind : kinds)
    for (PlannedBlunder& blunder : planning.of(kind)) all.push_back(std::move(blunder));
  return all;
}

}  // namespace plumb
