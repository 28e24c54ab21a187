#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/errors.h"
#include "engine/case/case_source.h"
#include "engine/integrate/method_info.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace load_case_test {

const std::string cases = PLUMB_SOURCE_DIR "/cases/";

/// The small case with one replacement in its text.
Case small_with(const std::string& from, const std::string& to) {
  CaseSource source = small_case();
  source.file.text = with(source.file.text, from, to);
  return load_case(source).spec;
}

TEST(LoadCase, ThePendulumIsReadAsTheReportStatesIt) {
  const Case spec = load_case(cases + "pendulum.toml").spec;
  EXPECT_EQ(spec.title, "Spatial cable pendulum");
  EXPECT_EQ(spec.parameters, (std::map<std::string, double>{{"f", 5}}));
  EXPECT_EQ(spec.cable.length, 1);
  EXPECT_DOUBLE_EQ(spec.cable.area, 25e-6);
  EXPECT_DOUBLE_EQ(spec.cable.density, 320);
  EXPECT_DOUBLE_EQ(spec.cable.youngs_modulus, 1.6e6);
  EXPECT_NEAR(spec.cable.youngs_modulus * spec.cable.second_moment, 7.95774715459e-5, 0.5e-16);
  EXPECT_EQ(spec.cable.elements, 4);
  EXPECT_EQ(spec.cable.strain, StrainModel::green_geometric);
  EXPECT_EQ(spec.cable.quadrature, QuadratureRule::full);
  EXPECT_EQ(spec.start.direction, Vec3(1, 0, 0));
  EXPECT_EQ(spec.start.angular_velocity, Vec3(0, 4, 0));
  EXPECT_EQ(spec.start.slope_rates, SlopeRates::rigid);
  EXPECT_EQ(spec.supports, (SupportsSpec{Support::pinned, Support::free}));
  EXPECT_EQ(spec.loads.gravity, Vec3(0, -9.81, 0));
  EXPECT_EQ(spec.method.name, "arkode-erk");
  EXPECT_EQ(spec.method.rtol, 1e-10);
  EXPECT_EQ(spec.method.atol, 1e-10);
  EXPECT_FALSE(spec.method.step.has_value());
  EXPECT_EQ(spec.time, (TimeSpec{2, 0.02}));
  ASSERT_EQ(spec.probes.size(), 2U);
  EXPECT_EQ(spec.probes[0], (ProbeSpec{"mid", 0.5, Quantity::position}));
  EXPECT_EQ(spec.probes[1], (ProbeSpec{"tip", 1, Quantity::position}));
  ASSERT_EQ(spec.references.size(), 2U);
  EXPECT_EQ(spec.references[0].compare,
            (std::vector<Comparison>{{"mid_y", "mid.y"}, {"tip_x", "tip.x"}, {"tip_z", "tip.z"}}));
  EXPECT_EQ(spec.references[0].tolerance, 0.01);
  EXPECT_EQ(spec.references[1].tolerance, 0.016);
  ASSERT_EQ(spec.figures.size(), 2U);
  EXPECT_EQ(spec.figures[0].y, "mid.y");
  EXPECT_TRUE(spec.figures[1].equal_axes);
  EXPECT_EQ(spec.scene, SceneSpec{}) << "the case writes out the defaults";
}

TEST(LoadCase, ThePublishedPendulumDiffersWhereThePublishedRunDid) {
  const Case stated = load_case(cases + "pendulum.toml").spec;
  const Case spec = load_case(cases + "pendulum_published.toml").spec;
  EXPECT_EQ(spec.loads.gravity, Vec3(0, -9.8, 0));
  EXPECT_EQ(spec.start.slope_rates, SlopeRates::zero);
  EXPECT_EQ(spec.method.name, "linearly-implicit-euler");
  EXPECT_EQ(spec.method.step, 1e-4);
  ASSERT_EQ(spec.references.size(), 1U);
  EXPECT_EQ(spec.references[0].tolerance, 1e-5);
  EXPECT_EQ(spec.cable, stated.cable);
  EXPECT_EQ(spec.supports, stated.supports);
  EXPECT_EQ(spec.start.angular_velocity, stated.start.angular_velocity);
  EXPECT_EQ(spec.time, stated.time);
  EXPECT_EQ(spec.probes, stated.probes);
  EXPECT_EQ(spec.figures, stated.figures);
}

TEST(LoadCase, ThePendulumsReferencesHoldTheirFigures) {
  const LoadedCase loaded = load_case(cases + "pendulum.toml");
  ASSERT_EQ(loaded.references.size(), 2U);
  const Reference& published = loaded.references[0];
  EXPECT_EQ(published.kind, ReferenceKind::published);
  ASSERT_EQ(published.times.size(), 101U);
  for (std::size_t i = 0; i < published.times.size(); ++i) {
    EXPECT_DOUBLE_EQ(published.times[i], 0.02 * static_cast<double>(i));
  }
  ASSERT_EQ(published.series.size(), 3U);
  EXPECT_EQ(published.find("mid_y")->values[1], -0.00195);
  EXPECT_EQ(published.find("tip_x")->values.back(), -0.24768);
  EXPECT_EQ(published.find("tip_z")->values.back(), 0.90344);
  EXPECT_EQ(published.find("mid_z"), nullptr);
  for (const ReferenceSeries& series : published.series) {
    EXPECT_EQ(series.unit, "m");
    EXPECT_EQ(series.uncertainty, 5e-6);
    EXPECT_EQ(series.values.size(), published.times.size());
  }
  const Reference& converged = loaded.references[1];
  EXPECT_EQ(converged.kind, ReferenceKind::computed);
  EXPECT_EQ(converged.times.size(), 100U);
  EXPECT_EQ(converged.find("tip_z")->values.back(), 0.9032090);
}

TEST(LoadCase, EveryKeyOfTheSmallCaseIsTaken) {
  const LoadedCase loaded = load_case(small_case());
  const Case& spec = loaded.spec;
  EXPECT_EQ(spec.parameters, (std::map<std::string, double>{{"f", 5}, {"g", 10}}));
  EXPECT_EQ(spec.cable.second_moment, 5e-11);
  EXPECT_TRUE(spec.start.direction.isApprox(Vec3(0.6, 0, 0.8), 1e-15));
  EXPECT_DOUBLE_EQ(spec.loads.gravity.y(), -9.81);
  EXPECT_EQ(spec.method.step, 1e-3);
  EXPECT_EQ(spec.method.parameters.at("spectral_radius"), 0.9);
  EXPECT_EQ(spec.method.parameters.at("newton_iterations"), 15);
  EXPECT_EQ(spec.probes[1], (ProbeSpec{"pull", 0, Quantity::axial_force}));
  EXPECT_EQ(spec.references[0], (ReferenceUse{"book",
                                              "small_reference.toml",
                                              {{"mid_y", "mid.y"}, {"force", "pull"}},
                                              Norm::rms,
                                              0.01,
                                              "because",
                                              {}}));
  EXPECT_EQ(spec.figures[0], (FigureSpec{"height", "Height", "t", "mid.y", "time", "height", "book", false}));
  EXPECT_EQ(spec.scene.size, (std::array<int, 2>{640, 480}));
  EXPECT_EQ(spec.scene.frame_rate, 10);
  EXPECT_EQ(spec.scene.cable_radius, 0.01);
  ASSERT_TRUE(spec.scene.camera.has_value());
  EXPECT_EQ(spec.scene.camera->eye, Vec3(0, 0, 5));
  EXPECT_EQ(spec.scene.camera->field_of_view, 40);
  const Reference& reference = loaded.references[0];
  EXPECT_EQ(reference.source, "A book");
  EXPECT_EQ(reference.obtained, "by hand");
  EXPECT_EQ(reference.notes, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(reference.find("mid_y")->figure, "Fig. 1");
  EXPECT_EQ(reference.find("mid_y")->uncertainty_basis, "thickness of the line");
  EXPECT_EQ(reference.find("mid_y")->values, (std::vector<double>{0, -0.1, -0.2}));
  EXPECT_EQ(reference.find("force")->values, (std::vector<double>{1, 2.5, 3.5}));
  EXPECT_TRUE(loaded.remarks.empty());
}

TEST(LoadCase, TheLookOfASceneIsTaken) {
  CaseSource source = small_case();
  const std::string text = source.file.text;
  source.file.text = text.substr(0, text.find("[scene.camera]")) +
                     "camera = \"orbit\"\ntheme = \"dark\"\nbackground = \"transparent\"\n"
                     "color_by = \"bending-moment\"\nghosts = 5\nghost_interval = 0.25\ntrail = 0\n";
  const SceneSpec scene = load_case(source).spec.scene;
  EXPECT_FALSE(scene.camera.has_value());
  EXPECT_EQ(scene.view, View::orbit);
  EXPECT_EQ(scene.theme, SceneTheme::dark);
  EXPECT_EQ(scene.background, SceneBackground::transparent);
  EXPECT_EQ(scene.color_by, ColorField::bending_moment);
  EXPECT_EQ(scene.ghosts, 5);
  EXPECT_EQ(scene.ghost_interval, 0.25);
  EXPECT_EQ(scene.trail, 0.0);
}

TEST(LoadCase, ACameraOfParallelRaysIsTaken) {
  CaseSource source = small_case();
  source.file.text = with(source.file.text, "field_of_view = 40", "view_height = 2.5");
  EXPECT_EQ(load_case(source).spec.scene.camera->view_height, 2.5);
}

TEST(LoadCase, ACameraIsReplacedByAWord) {
  CaseSource source = small_case();
  source.overrides = {"scene.camera=top"};
  const SceneSpec scene = load_case(source).spec.scene;
  EXPECT_EQ(scene.view, View::top);
  EXPECT_FALSE(scene.camera.has_value());
}

TEST(LoadCase, WhatIsLeftOutHasItsDefault) {
  const Case spec = load_case(CaseSource{{"least.toml", R"(
title = "Least"
[cable]
length = 1
area = 2
density = 3
youngs_modulus = 4
elements = 5
[method]
name = "cvode-bdf"
[time]
end = 1
output_interval = 0.3
[[probe]]
name = "a"
at = 0
[[figure]]
name = "p"
y = "a.x"
)"},
                                         {},
                                         {}})
                        .spec;
  EXPECT_DOUBLE_EQ(spec.cable.second_moment, 1 / std::numbers::pi);
  EXPECT_EQ(spec.start, StartSpec{});
  EXPECT_EQ(spec.supports, SupportsSpec{});
  EXPECT_EQ(spec.loads, LoadsSpec{});
  EXPECT_EQ(spec.method.rtol, find_method(spec.method.name)->rtol);
  EXPECT_EQ(spec.method.atol, find_method(spec.method.name)->rtol);
  ASSERT_EQ(spec.method.parameters.size(), find_method("cvode-bdf")->parameters.size());
  for (const MethodParameter& parameter : find_method("cvode-bdf")->parameters) {
    EXPECT_EQ(spec.method.parameters.at(parameter.name), parameter.fallback);
  }
  EXPECT_EQ(spec.probes[0].quantity, Quantity::position);
  EXPECT_EQ(spec.figures[0], (FigureSpec{"p", "p", "t", "a.x", "t", "a.x", "", false}));
  EXPECT_EQ(spec.scene, SceneSpec{});
  EXPECT_TRUE(spec.references.empty());
}

TEST(LoadCase, AReferenceIsNamedAfterItsFileUnlessNamed) {
  CaseSource source = small_case();
  source.file.text = with(source.file.text, "name = \"book\"\n", "");
  source.file.text = with(source.file.text, "reference = \"book\"\n", "");
  EXPECT_EQ(load_case(source).spec.references.at(0).name, "small_reference");
  source.file.text = with(source.file.text, "small_reference.toml", "a b.toml");
  source.references[0].name = "a b.toml";
  EXPECT_EQ(
      refusal(source),
      "case.toml:39:1: reference.0.name: must be letters, digits, - and _, at most 100, not starting with - "
      "(it is \"a b\", from the file's name, unless given)");
}

TEST(LoadCase, AtolFollowsRtolUnlessGiven) {
  const std::string method =
      "name = \"generalized-alpha\"\nstep = 1e-3\nspectral_radius = 0.9\nnewton_iterations = 15";
  EXPECT_EQ(small_with(method, "name = \"cvode-bdf\"\nrtol = 1e-6").method.atol, 1e-6);
  EXPECT_EQ(small_with(method, "name = \"cvode-bdf\"\nrtol = 1e-6\natol = 1e-9").method.atol, 1e-9);
}

TEST(LoadCase, ParametersMayStandInAnyOrder) {
  const Case spec = small_with("f = 5\ng = \"2 * f\"", "g = \"2 * f\"\nf = \"h + 1\"\nh = 4");
  EXPECT_EQ(spec.parameters, (std::map<std::string, double>{{"f", 5}, {"g", 10}, {"h", 4}}));
}

TEST(LoadCase, TheSourceOfACaseGivesTheSameCaseAgain) {
  for (const char* name : {"pendulum.toml", "pendulum_published.toml"}) {
    const LoadedCase first =
        load_case(cases + name, {"cable.elements=7", "time.end=1", "method.name=rk4", "method.step=1e-3"});
    const LoadedCase second = load_case(first.source);
    EXPECT_EQ(second.spec, first.spec) << name;
    EXPECT_EQ(second.remarks, first.remarks) << name;
    ASSERT_EQ(second.references.size(), first.references.size());
    for (std::size_t i = 0; i < first.references.size(); ++i) {
      EXPECT_EQ(second.references[i].times, first.references[i].times) << name;
      EXPECT_EQ(second.references[i].series[0].values, first.references[i].series[0].values) << name;
    }
    EXPECT_EQ(second.source.file.text, text_of_file(cases + name));
  }
}

TEST(LoadCase, AFileThatIsNotThereIsNamedWithTheReason) {
  try {
    load_case("nowhere/none.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "nowhere/none.toml: cannot be read: No such file or directory");
  }
  try {
    load_case(PLUMB_TEST_DATA);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), std::string(PLUMB_TEST_DATA) + ": cannot be read: Is a directory");
  }
}

TEST(LoadCase, AReferenceIsLookedForBesideTheCase) {
  const std::string path = PLUMB_TEST_DATA "/small_case.toml";
  EXPECT_EQ(load_case(path).references.at(0).title, "A small table");
  try {
    load_case(path, {"reference.0.file=absent.toml"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--set reference.0.file=absent.toml: cannot be read: No such file or directory");
  }
}

TEST(LoadCase, TheNameOfAFileKeepsItsSpaces) {
  CaseSource source = small_case();
  source.file.text = with(source.file.text, "small_reference.toml", "two  spaces.toml");
  source.references[0].name = "two  spaces.toml";
  EXPECT_EQ(load_case(source).spec.references.at(0).file, "two  spaces.toml");
}

TEST(LoadCase, AFaultInAReferenceIsNamedByItsPathFromHere) {
  CaseSource source = small_case();
  source.file.name = "cases/case.toml";
  source.references[0].text = with(source.references[0].text, "2.5]", "nan]");
  EXPECT_EQ(refusal(source),
            "cases/small_reference.toml:10:15: rows.1.2 = nan: must be finite: a number (N)");
}

TEST(LoadCase, TimesOfAReferenceBeyondTheRunAreRemarkedOn) {
  CaseSource source = small_case();
  source.overrides = {"time.end=0.5"};
  EXPECT_EQ(
      load_case(source).remarks,
      (std::vector<std::string>{"1 of the 3 times of small_reference.toml are beyond the end of the run, 0.5 "
                                "s: a criterion is not run unless its coverage says that it claims less"}));
}

TEST(LoadCase, AFaultInADefaultNamesTheKeyToGive) {
  CaseSource source = small_case();
  const std::string& text = source.file.text;
  source.file.text = text.substr(0, text.find("[scene]"));
  source.overrides = {"time.end=1e5", "reference=[]", "figure=[]"};
  EXPECT_EQ(
      refusal(source),
      "case.toml:1:1: scene.frame_rate: gives 2.5e+06 frames until the end time, 100000 s; at most 100000 "
      "are allowed; give a lower rate");
}

TEST(LoadCase, AParameterThatNothingUsesIsRemarkedOn) {
  CaseSource source = small_case();
  source.overrides = {"parameters.ff=3"};
  EXPECT_EQ(load_case(source).remarks, (std::vector<std::string>{"parameters.ff is not used"}));
}

TEST(LoadCase, ALongCommentIsNoKey) {
  std::string comment = "#";
  for (int i = 0; i < 200; ++i) comment += " One sentence here.";
  CaseSource source;
  source.file = {
      "long.toml",
      comment +
          "\ntitle = \"a\"\n[cable]\nlength = 1\narea = 1e-6\ndensity = 1000\nyoungs_modulus = 1e6\n"
          "elements = 1\n[method]\nname = \"rk4\"\nstep = 0.1\n[time]\nend = 1\noutput_interval = 1\n"};
  EXPECT_EQ(load_case(source).spec.cable.elements, 1);
}

}  // namespace load_case_test
}  // namespace plumb
