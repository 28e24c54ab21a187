#include "engine/study/reference/method_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/pendulum.h"

namespace plumb {
namespace study_curves_test {

std::vector<CurvePlan> all_curves(const Case& spec) {
  const WorkPrecisionSpec study = work_precision_of(spec);
  return study_curves(study, study.full, spec.time.output_interval, false);
}

TEST(StudyCurves, EveryMethodOfMotionHasOneAtLeastAndKeepsToWhatItTakes) {
  const Case spec = pendulum(5, 4);
  const std::vector<CurvePlan> curves = all_curves(spec);
  for (const MethodInfo& info : method_infos())
    EXPECT_EQ(
        std::any_of(curves.begin(), curves.end(), [&](const CurvePlan& c) { return c.method == &info; }),
        info.dynamic)
        << info.name;
  for (const CurvePlan& curve : curves) {
    EXPECT_GE(curve.points.size(), 3U) << curve.label;
    for (const MethodSpec& point : curve.points) {
      EXPECT_NE(point.step.has_value(), point.rtol.has_value()) << curve.label;
      EXPECT_TRUE(point.step ? curve.method->takes_step : curve.method->takes_tolerances) << curve.label;
      for (const MethodParameter& parameter : curve.method->parameters) {
        ASSERT_TRUE(point.parameters.contains(parameter.name)) << curve.label;
        EXPECT_GE(point.parameters.at(parameter.name), parameter.minimum);
        EXPECT_LE(point.parameters.at(parameter.name), parameter.maximum);
      }
    }
  }
}

TEST(StudyCurves, LabelsAreUnique) {
  std::vector<std::string> labels;
  for (const CurvePlan& curve : all_curves(pendulum(5, 4))) labels.push_back(curve.label);
  std::sort(labels.begin(), labels.end());
  EXPECT_EQ(std::adjacent_find(labels.begin(), labels.end()), labels.end());
}

TEST(StudyCurves, StepsFallAndDivideTheOutputInterval) {
  const Case spec = pendulum(5, 4);
  for (const CurvePlan& curve : all_curves(spec))
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      const MethodSpec& point = curve.points[k];
      if (!point.step) continue;
      const double parts = spec.time.output_interval / *point.step;
      EXPECT_NEAR(parts, std::round(parts), 1e-9 * parts) << *point.step;
      if (k > 0) {
        EXPECT_LT(*point.step, *curve.points[k - 1].step);
      }
    }
}

TEST(StudyCurves, DrawEveryValueThatAMethodSaysIsWorthACurve) {
  const std::vector<CurvePlan> curves = all_curves(pendulum(5, 4));
  int varied = 0;
  for (const MethodInfo& info : method_infos())
    for (const double value : info.varied.values) {
      ++varied;
      EXPECT_TRUE(std::any_of(curves.begin(), curves.end(),
                              [&](const CurvePlan& c) {
                                return c.method == &info &&
                                       c.points.front().parameters.at(info.varied.name) == value;
                              }))
          << info.name << ", " << info.varied.name << " = " << value;
    }
  EXPECT_GT(varied, 0);
}

TEST(StudyCurves, VariantsStateTheirOwnOrder) {
  const std::vector<CurvePlan> curves = all_curves(pendulum(5, 4));
  const auto labelled = [&](const std::string& label) {
    const auto found =
        std::find_if(curves.begin(), curves.end(), [&](const CurvePlan& c) { return c.label == label; });
    EXPECT_NE(found, curves.end()) << label;
    return found != curves.end() ? *found : CurvePlan{};
  };
  EXPECT_EQ(labelled("arkode-erk, order 5, fixed step").stated_order, "5");
  EXPECT_EQ(labelled("cvode-bdf, order ≤ 2").stated_order, "1 to 2");
}

}  // namespace study_curves_test
}  // namespace plumb
