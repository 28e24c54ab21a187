#include "engine/study/variants/variant_figure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace variant_figure_test {

std::vector<double> vibration(double growth, double angle, double offset, int count) {
  std::vector<double> x;
  for (int k = 0; k < count; ++k) x.push_back(offset + std::pow(growth, k) * std::cos(angle * k + 0.3));
  return x;
}

TEST(Growth, IsThatOfAVibrationAboutAnyMean) {
  for (const double growth : {0.9, 0.9999, 1.0, 1.0456, 1.379})
    for (const double offset : {0.0, 2.0})
      EXPECT_NEAR(growth_of(vibration(growth, 1.1, offset, 40)), growth, 1e-9) << growth << " " << offset;
}

TEST(Growth, IsNotANumberWhereNothingVibratesOrThereIsTooLittle) {
  EXPECT_TRUE(std::isnan(growth_of(vibration(1, 1.1, 0, 9))));
  EXPECT_TRUE(std::isnan(growth_of(std::vector<double>(40, 3.0))));
  EXPECT_TRUE(std::isnan(growth_of(std::vector<double>(40, 0.0))));
}

/// Two outputs of one element; the last node moves by `by` along y.
VariantResult made(const std::string& name, double by, double energy) {
  VariantResult variant;
  variant.spec.name = name;
  variant.run.probes = {{"tip", 1, Quantity::position}};
  Trajectory& t = variant.trajectory;
  t.outcome = Outcome::completed;
  t.times = {0, 0.5};
  t.end_time = 0.5;
  t.q = {Eigen::VectorXd::Zero(12), Eigen::VectorXd::Zero(12)};
  t.q[1][7] = by;
  t.energies = {{2, 0, 0, 1}, {0, energy, 0, 0}};
  variant.probes.times = t.times;
  variant.probes.columns = {{"tip.x", "m", {3, 1}}, {"tip.y", "m", {0, by}}};
  return variant;
}

ExpectationFound found(const std::string& quantity, const VariantResult& variant,
                       const std::vector<VariantResult>& all = {}, const std::string& from = "") {
  return find_figure({quantity, from, 0, 1, "test"}, variant, all);
}

TEST(VariantFigure, IsReadOffTheRunWithItsUnit) {
  const VariantResult variant = made("a", -0.25, 4.5);
  EXPECT_EQ(found("end-time", variant).found, 0.5);
  EXPECT_EQ(found("end-time", variant).unit, "s");
  EXPECT_EQ(found("energy-ratio", variant).found, 1.5);
  EXPECT_EQ(found("energy-change", variant).found, 0.75);
  EXPECT_EQ(found("energy-drift", variant).found, 0.75);
  EXPECT_EQ(found("tip.x", variant).found, 1);
  EXPECT_EQ(found("tip.x", variant).unit, "m");
  EXPECT_EQ(found("greatest tip.x", variant).found, 3);
  EXPECT_EQ(found("least tip.y", variant).found, -0.25);
  EXPECT_EQ(found("time of least tip.y", variant).found, 0.5);
  EXPECT_EQ(found("time of least tip.y", variant).unit, "s");
  EXPECT_TRUE(std::isnan(found("period tip.x", variant).found)) << "it does not come back";
}

TEST(VariantFigure, DistanceIsThatOfTheSameNodeAtTheSameTime) {
  const std::vector<VariantResult> all{made("a", -0.25, 1), made("b", 0.5, 1)};
  EXPECT_EQ(found("distance", all[0], all, "b").found, 0.75);
}

TEST(VariantFigure, WhatARunDoesNotHaveIsNotMet) {
  VariantResult variant = made("a", 0, 1);
  const ExpectationFound drift = found("constraint-drift", variant);
  EXPECT_TRUE(std::isnan(drift.found));
  EXPECT_FALSE(drift.met());
  variant.trajectory.energies.clear();
  EXPECT_FALSE(found("energy-ratio", variant).met());
}

TEST(VariantFigure, IsMetWithinItsMarginOnBothSides) {
  ExpectationFound figure{{"end-time", "", 2, 0.5, "test"}, "s", 0};
  for (const auto& [value, met] : {std::pair{1.4, false}, {1.5, true}, {2.5, true}, {2.6, false}}) {
    figure.found = value;
    EXPECT_EQ(figure.met(), met) << value;
  }
}

}  // namespace variant_figure_test
}  // namespace plumb
