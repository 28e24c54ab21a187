#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/model/cable.h"
#include "engine/model/greatest_eigenfrequency.h"
#include "engine/model/own_units.h"
#include "tests/engine/pendulum.h"

namespace plumb {
namespace scaling_test {

/// Powers of two by which the units of length, mass and time differ from a case to another.
struct Exponents {
  int length, mass, time;
};

constexpr Exponents samples[]{{-40, -60, -20}, {20, 30, 20}, {-20, 0, 0}, {7, -13, -3}};

/// A soft cable that moves in all directions under its weight and a force on its end.
Case soft_cable(Support first) {
  Case spec = pendulum(5, 4);
  spec.supports.first = first;
  spec.start.direction = {0.6, 0, 0.8};
  spec.loads.end_force = {0, 0.01, 0.02};
  spec.time = {0.02, 0.01};
  return spec;
}

/// The same with a mass on it, under loads that change with time or turn with it, and damped; held at an end
/// that moves.
Case loaded_cable(Support first) {
  Case spec = soft_cable(first);
  spec.parameters = {{"metre", 1}, {"unit", 1}};
  if (first != Support::free)
    spec.supports.first_motion = MotionSpec{"0.1*metre*sin(50*t/unit)", "0", "0.3*metre*t/unit"};
  if (first == Support::clamped)
    spec.supports.first_rotation = RotationSpec{{0, 1, 0}, "3*t/unit + (40*t/unit)^2"};
  spec.start.stretch = 1.01;
  spec.loads.applied = {{LoadKind::force, 0.7, {0.01, 0, 0.02}, false, "1 + sin(50 * t / unit)"},
                        {LoadKind::moment, 1, {0, 0.001, 0}, true, "1"},
                        {LoadKind::distributed, 0, {0, 0.01, 0.01}, true, "exp(-t / unit)"},
                        {LoadKind::force, 0.3, {0, 0.01, 0}, false, "1"}};
  spec.masses = {{0.6, 0.01}};
  spec.damping = {0.5, 1e-4};
  return spec;
}

Case in_other_units(Case spec, const Exponents& k) {
  const double L = std::exp2(k.length), M = std::exp2(k.mass), T = std::exp2(k.time);
  spec.cable.length *= L;
  spec.cable.area *= L * L;
  spec.cable.density *= M / (L * L * L);
  spec.cable.youngs_modulus *= M / (L * T * T);
  spec.cable.second_moment *= L * L * L * L;
  spec.start.angular_velocity /= T;
  spec.loads.gravity *= L / (T * T);
  spec.loads.end_force *= M * L / (T * T);
  for (LoadSpec& load : spec.loads.applied)
    load.value *= M / (T * T) *
                  (load.kind == LoadKind::moment        ? L * L
                   : load.kind == LoadKind::distributed ? 1
                                                        : L);
  for (MassSpec& mass : spec.masses) mass.mass *= M;
  spec.damping = {spec.damping.mass / T, spec.damping.material * T};
  if (!spec.parameters.empty()) spec.parameters = {{"metre", L}, {"unit", T}};
  spec.time = {spec.time.end * T, spec.time.output_interval * T};
  if (spec.method.step) *spec.method.step *= T;
  return spec;
}

std::vector<MethodSpec> settings_of(const MethodInfo& info) {
  std::vector<MethodSpec> settings;
  if (!info.dynamic)
    settings.push_back(method(info.name, 5e-3));
  else if (info.takes_step)
    settings.push_back(method(info.name, 5e-4));
  if (info.takes_tolerances) settings.push_back(method(info.name, {}, 1e-4));
  return settings;
}

void expect_no_bit_to_change(Case (*cable)(Support)) {
  for (const MethodInfo& info : method_infos())
    for (const MethodSpec& with : settings_of(info))
      for (const Support first : {Support::free, Support::pinned, Support::clamped}) {
        if (!info.dynamic && first != Support::clamped) continue;
        Case spec = cable(first);
        if (!takes(info, spec)) continue;
        // Supports that move it refuses, and in a frame that turns loads across the axis.
        if (info.timeless && spec.supports.move()) continue;
        if (info.timeless) spec.start.angular_velocity.setZero();
        spec.method = with;
        const Trajectory as_it_is = integrate(spec);
        ASSERT_EQ(as_it_is.outcome, Outcome::completed) << info.name << ": " << as_it_is.message;
        for (const Exponents& k : samples) {
          const std::string where =
              fmt::format("{}, {}, 2^({}, {}, {})", info.name, word(first), k.length, k.mass, k.time);
          Trajectory scaled = integrate(in_other_units(spec, k));
          ASSERT_EQ(scaled.outcome, Outcome::completed) << where << ": " << scaled.message;
          EXPECT_EQ(scaled.counters.steps, as_it_is.counters.steps) << where;
          EXPECT_EQ(scaled.counters.newton_iterations, as_it_is.counters.newton_iterations) << where;
          EXPECT_EQ(scaled.counters.force_evaluations, as_it_is.counters.force_evaluations) << where;
          for (std::size_t m = 0; m < as_it_is.vibrations.modes.size(); ++m)
            EXPECT_EQ(std::exp2(k.time) * scaled.vibrations.modes.at(m).frequency,
                      as_it_is.vibrations.modes[m].frequency)
                << where << ", mode " << m + 1;
          scale_nodal(std::exp2(-k.length), 1, scaled.q.back());
          scale_nodal(std::exp2(k.time - k.length), std::exp2(k.time), scaled.v.back());
          EXPECT_EQ((scaled.q.back() - as_it_is.q.back()).lpNorm<Eigen::Infinity>(), 0) << where;
          EXPECT_EQ((scaled.v.back() - as_it_is.v.back()).lpNorm<Eigen::Infinity>(), 0) << where;
          const Energies &energies = as_it_is.energies.back(), &scaled_energies = scaled.energies.back();
          const double joule = std::exp2(k.mass + 2 * (k.length - k.time));
          EXPECT_EQ(scaled_energies.work, joule * energies.work) << where;
          EXPECT_EQ(scaled_energies.dissipated, joule * energies.dissipated) << where;
        }
      }
}

TEST(Scaling, ChangesNoBitOfAnyMethod) {
  expect_no_bit_to_change(soft_cable);
}

TEST(Scaling, ChangesNoBitUnderLoadsThatChangeOrFollowWithMassesAndDamping) {
  Case spec = loaded_cable(Support::pinned);
  spec.method = method("rk4", 5e-4);
  const Trajectory run = integrate(spec);
  EXPECT_NE(run.energies.back().work, 0);
  EXPECT_GT(run.energies.back().dissipated, 0);
  expect_no_bit_to_change(loaded_cable);
}

/// A clamped bar with a rectangular section under a force on its end, along no axis.
Case cantilever(double length, double width, double height, double density, double youngs_modulus) {
  Case spec;
  spec.title = "cantilever";
  spec.cable = {.length = length,
                .area = width * height,
                .density = density,
                .youngs_modulus = youngs_modulus,
                .second_moment = width * height * height * height / 12,
                .elements = 4};
  spec.supports.first = Support::clamped;
  spec.start.direction = {0.6, 0.8, 0};
  spec.loads.end_force = {0, 0, 0.1 * youngs_modulus * spec.cable.second_moment / (length * length)};
  return spec;
}

// At rest it would bend by PL³/3EI; let go, by up to twice that, a half period of its first vibration later.
// That is a long time for methods whose steps the axial vibrations limit, which go a little of the way.
void expect_to_bend(const Case& spec) {
  const double L = spec.cable.length, EI = spec.cable.youngs_modulus * spec.cable.second_moment;
  const double omega = 3.51601527 / (L * L) * std::sqrt(EI / (spec.cable.density * spec.cable.area));
  const double rest = spec.loads.end_force.z() * L * L * L / (3 * EI), half = std::numbers::pi / omega;
  const Cable cable(spec);
  const double fastest = fastest_vibration(cable, cable.start_q(spec.start)).frequency;
  for (const MethodInfo& info : method_infos()) {
    Case with = spec;
    with.method = info.takes_step ? method(info.name, info.implicit ? half / 200 : 1 / fastest)
                                  : method(info.name, {}, 1e-4);
    const bool whole = info.family == MethodFamily::structural || !info.dynamic;
    with.time.end = with.time.output_interval = whole ? half : half / 50;
    const Trajectory run = integrate(with);
    ASSERT_EQ(run.outcome, Outcome::completed) << info.name << ": " << run.message;
    const double z = tip(run).z() / rest;
    if (whole) {
      EXPECT_NEAR(z, info.dynamic ? 2 : 1, 0.2) << info.name;
    } else {
      EXPECT_TRUE(z > 1e-3 && z < 0.1) << info.name << " bends by " << z;
    }
  }
}

TEST(Scaling, SiliconCantileverOfAHundredMicrometresBendsWithEveryMethod) {
  expect_to_bend(cantilever(100e-6, 10e-6, 2e-6, 2330, 169e9));
}

TEST(Scaling, PolymerCantileverTenNanometresThickBendsWithEveryMethod) {
  expect_to_bend(cantilever(20e-6, 2e-6, 10e-9, 1200, 3e9));
}

}  // namespace scaling_test
}  // namespace plumb
