#include "engine/read/model_numbers.h"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/read/uncertain_keys.h"

namespace plumb {
namespace {

/// A number with what scales it.
struct Scalable {
  ModelNumber number;
  std::vector<std::string> (*scale)(const Case& spec, const std::string& key, double factor);
};

std::string set(std::string_view key, double value) {
  return fmt::format("{}={}", key, value);
}

/// Of a number of its own, or one of a list, which is spelled out.
std::vector<std::string> scaled_key(const Case& spec, const std::string& key, double factor) {
  const double value = factor * *uncertain_value(spec, key);
  std::vector<std::string> overrides = uncertain_overrides(spec, {key}, {value});
  overrides.back() = set(key, value);
  return overrides;
}

std::size_t place_in(const std::string& key) {
  return std::stoul(key.substr(key.find('.') + 1));
}

void add_cable(const CableSpec& cable, std::vector<Scalable>& all) {
  all.push_back({{"cable.length", "length"}, scaled_key});
  all.push_back({{"cable.density", "density"}, scaled_key});
  if (cable.model == CableModel::rigid) return;
  const bool bends = cable.model == CableModel::cable && cable.second_moment > 0;
  if (bends)
    all.push_back({{"cable.youngs_modulus", "Young's modulus"},
                   [](const Case& spec, const std::string&, double factor) {
                     return std::vector{set("cable.youngs_modulus", factor * spec.cable.youngs_modulus),
                                        set("cable.second_moment", spec.cable.second_moment)};
                   }});
  all.push_back(
      {{"cable.axial_stiffness", "axial stiffness"}, [](const Case& spec, const std::string&, double factor) {
         std::vector<std::string> overrides{set("cable.youngs_modulus", factor * spec.cable.youngs_modulus)};
         if (spec.cable.model == CableModel::cable)
           overrides.push_back(set("cable.second_moment", spec.cable.second_moment / factor));
         return overrides;
       }});
  if (bends)
    all.push_back({{"cable.bending_stiffness", "bending stiffness"},
                   [](const Case& spec, const std::string&, double factor) {
                     return std::vector{set("cable.second_moment", factor * spec.cable.second_moment)};
                   }});
}

void add_vector(const char* key, const char* words, const Vec3& value, std::vector<Scalable>& all) {
  for (int k = 0; k < 3; ++k)
    if (value[k] != 0)
      all.push_back(
          {{fmt::format("{}.{}", key, k), fmt::format("{} along {}", words, "xyz"[k])}, scaled_key});
}

void add_motion(const char* key, const char* words, const std::optional<MotionSpec>& motion,
                std::vector<Scalable>& all) {
  if (!motion) return;
  visit_keys(*motion, [&](const Key& axis, const std::string& way) {
    if (way == "0") return;
    all.push_back({{fmt::format("{}.{}", key, axis.name), fmt::format("{} along {}", words, axis.name)},
                   [](const Case& spec, const std::string& of, double factor) {
                     const bool first = of.starts_with("supports.first");
                     const MotionSpec& moved =
                         first ? *spec.supports.first_motion : *spec.supports.last_motion;
                     std::string own;
                     visit_keys(moved, [&](const Key& any, const std::string& expression) {
                       if (of.ends_with(any.name)) own = expression;
                     });
                     return std::vector{fmt::format("{}=\"{} * ({})\"", of, factor, own)};
                   }});
  });
}

std::vector<Scalable> scalables(const Case& spec) {
  std::vector<Scalable> all;
  add_cable(spec.cable, all);
  add_vector("start.angular_velocity", "angular velocity", spec.start.angular_velocity, all);
  if (spec.start.stretch != 1)
    all.push_back(
        {{"start.stretch", "stretch beyond 1"}, [](const Case& of, const std::string& key, double factor) {
           return std::vector{set(key, 1 + factor * (of.start.stretch - 1))};
         }});
  if (spec.start.axial_speed != 0) all.push_back({{"start.axial_speed", "axial speed"}, scaled_key});
  if (spec.start.imperfection != 0) all.push_back({{"start.imperfection", "imperfection"}, scaled_key});
  add_motion("supports.first_motion", "motion of the first end", spec.supports.first_motion, all);
  add_motion("supports.last_motion", "motion of the last end", spec.supports.last_motion, all);
  if (spec.supports.first_rotation)
    all.push_back({{"supports.first_rotation.angle", "rotation of the first end"},
                   [](const Case& of, const std::string& key, double factor) {
                     return std::vector{
                         fmt::format("{}=\"{} * ({})\"", key, factor, of.supports.first_rotation->angle)};
                   }});
  add_vector("loads.gravity", "gravity", spec.loads.gravity, all);
  add_vector("loads.end_force", "end force", spec.loads.end_force, all);
  for (std::size_t k = 0; k < spec.loads.applied.size(); ++k)
    if (!spec.loads.applied[k].value.isZero(0))
      all.push_back({{fmt::format("load.{}.value", k), fmt::format("load {}", k + 1)},
                     [](const Case& of, const std::string& key, double factor) {
                       return std::vector{set_vector(key, factor * of.loads.applied[place_in(key)].value)};
                     }});
  for (std::size_t k = 0; k < spec.masses.size(); ++k)
    all.push_back({{fmt::format("mass.{}.mass", k), fmt::format("mass {}", k + 1)},
                   [](const Case& of, const std::string& key, double factor) {
                     return std::vector{set(key, factor * of.masses[place_in(key)].mass)};
                   }});
  if (spec.damping.mass > 0) all.push_back({{"damping.mass", "damping by mass"}, scaled_key});
  if (spec.damping.material > 0) all.push_back({{"damping.material", "damping of the material"}, scaled_key});
  return all;
}

}  // namespace

std::vector<ModelNumber> model_numbers(const Case& spec) {
  std::vector<ModelNumber> numbers;
  for (Scalable& scalable : scalables(spec)) numbers.push_back(std::move(scalable.number));
  return numbers;
}

std::string set_vector(std::string_view key, const Vec3& value) {
  const Vec3 plain = value + Vec3::Zero();  // without a negative zero
  return fmt::format("{}=[{}, {}, {}]", key, plain[0], plain[1], plain[2]);
}

std::vector<std::string> scaled(const Case& spec, std::string_view key, double factor) {
  for (const Scalable& scalable : scalables(spec))
    if (scalable.number.key == key) return scalable.scale(spec, scalable.number.key, factor);
  throw std::invalid_argument(fmt::format("{} is no number of the model", key));
}

}  // namespace plumb
