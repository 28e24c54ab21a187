#include "report/study/work_precision/work_precision_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/gl/gl_context.h"
#include "render/plot/plot_layout.h"
#include "render/plot/plot_renderer.h"
#include "report/study/work_precision/compared_lines.h"
#include "tests/render/image/pictures.h"
#include "tests/report/study/work_precision/made_study.h"

namespace plumb {
namespace study_figures_test {

Figure named(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures)
    if (figure.name == name) return figure;
  throw std::out_of_range(name);
}

Series labelled(const Figure& figure, const std::string& label) {
  for (const Series& series : figure.plot.panels[0].series)
    if (series.label == label) return series;
  throw std::out_of_range(label);
}

// How many points of a figure have this marker, and no label that would make them samples.
std::size_t points_with(const Figure& figure, Marker marker) {
  std::size_t count = 0;
  for (const Series& series : figure.plot.panels[0].series)
    if (series.marker == marker) count += series.x.size();
  return count;
}

TEST(StudyFigures, AreFourWithWordsForThoseWhoCannotSeeThem) {
  const std::vector<Figure> figures = study_figures(made_study());
  ASSERT_EQ(figures.size(), 4U);
  for (const Figure& figure : figures) {
    EXPECT_GT(figure.alt.size(), 100U) << figure.name;
    EXPECT_FALSE(figure.title.empty());
    EXPECT_EQ(figure.plot.panels[0].x.scale, Scale::logarithmic) << figure.name;
    EXPECT_EQ(figure.plot.panels[0].y.scale, Scale::logarithmic) << figure.name;
  }
  EXPECT_NE(figures[0].alt.find("for 3 of 3 methods: 15 runs good, 1 wrong, 1 failed"), std::string::npos)
      << figures[0].alt;
}

TEST(StudyFigures, OfTimeShowTheFixedMeshOnly) {
  const WorkPrecision study = made_study();
  const Series line = labelled(named(study_figures(study), time_work_figure_name), "fourth");
  ASSERT_EQ(line.x.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const double step = 0.01 / std::pow(2.0, k);
    EXPECT_DOUBLE_EQ(line.x[k], 4e-7 / step) << "the least of the repeats";
    EXPECT_DOUBLE_EQ(line.y[k], 100 * std::pow(step, 4));
  }
}

TEST(StudyFigures, OfTheTotalShowEachRunOfEveryMeshOnce) {
  const WorkPrecision study = made_study();
  const Figure figure = named(study_figures(study), total_work_figure_name);
  std::size_t points = 0;
  for (const Series& series : figure.plot.panels[0].series)
    if (series.label != "Pareto front" && series.marker != Marker::cross &&
        series.marker != Marker::circled_cross)
      points += series.x.size();
  EXPECT_EQ(points, 30U);
}

TEST(StudyFigures, HaveTheCurveOfAnotherProgramWithItsNameAndAMarkerOfItsOwn) {
  WorkPrecision study = made_study();
  study.given_curves = {made_given_curve("laptop")};
  for (const char* name : {time_work_figure_name, total_work_figure_name}) {
    const Figure figure = named(study_figures(study), name),
                 without = named(study_figures(made_study()), name);
    const Series line = labelled(figure, "springs: Springs 1.0, 4 threads, another machine");
    ASSERT_EQ(line.x.size(), 3U);
    EXPECT_EQ(line.x[0], 0.25);
    EXPECT_EQ(line.y[1], name == std::string(time_work_figure_name) ? 0.005 : 0.015);
    EXPECT_TRUE(line.open_marker);
    EXPECT_EQ(line.marker, Marker::triangle_right);
    EXPECT_EQ(points_with(without, Marker::triangle_right), 0U);
    EXPECT_EQ(points_with(figure, Marker::cross), points_with(without, Marker::cross) + 1)
        << "the point without an error is at the edge";
    EXPECT_GT(figure.plot.panels[0].x.range.value()[1], 1.0) << "there is room for its slow points";
    EXPECT_NE(figure.alt.find("3 runs of springs: Springs 1.0"), std::string::npos) << figure.alt;
  }
}

TEST(StudyFigures, LineOfAMethodOverItsMeshesFallsAllTheWay) {
  const Series line = labelled(named(study_figures(made_study()), total_work_figure_name), "second");
  ASSERT_GT(line.x.size(), 2U);
  for (std::size_t k = 1; k < line.x.size(); ++k) {
    EXPECT_GT(line.x[k], line.x[k - 1]);
    EXPECT_LT(line.y[k], line.y[k - 1]);
  }
}

TEST(StudyFigures, DrawEveryFailureAtTheTopAndEveryWrongRunAtItsError) {
  const WorkPrecision study = made_study();
  for (const char* name : {time_work_figure_name, total_work_figure_name}) {
    const Figure figure = named(study_figures(study), name);
    const std::size_t meshes = name == std::string(time_work_figure_name) ? 1 : 2;
    EXPECT_EQ(points_with(figure, Marker::cross), meshes) << name;
    EXPECT_EQ(points_with(figure, Marker::circled_cross), meshes) << name;
    const auto& range = *figure.plot.panels[0].y.range;
    for (const Series& series : figure.plot.panels[0].series)
      for (const double y : series.y) {
        if (y < 0) continue;  // breaks a line
        EXPECT_LT(y, range[1]);
        EXPECT_GT(y, range[0]);
        if (series.marker == Marker::cross) {
          EXPECT_GT(y, 1) << "above every error";
        }
        if (series.marker == Marker::circled_cross) {
          EXPECT_EQ(y, 1);
        }
      }
  }
}

TEST(StudyFigures, FrontIsThatOfTheStudyWithoutWrongRuns) {
  const WorkPrecision study = made_study();
  const Series front = labelled(named(study_figures(study), time_work_figure_name), "Pareto front");
  std::vector<double> expected;
  for (const std::size_t k : study.time_front)
    if (fate_of(study, study.runs[k], StudyQuestion::time) == RunFate::good)
      expected.push_back(study.runs[k].work_seconds());
  EXPECT_EQ(front.x, expected);
  EXPECT_GT(expected.size(), 2U);
}

TEST(StudyFigures, FloorIsABandThatSaysWhetherItIsCertified) {
  WorkPrecision study = made_study();
  study.mesh_references[0].certified = false;
  study.mesh_references[0].floor = 1e-7;
  const Panel panel = named(study_figures(study), time_work_figure_name).plot.panels[0];
  ASSERT_EQ(panel.rules.size(), 1U);
  EXPECT_EQ(panel.rules[0].to, 1e-7);
  EXPECT_NE(panel.rules[0].label.find("not certified"), std::string::npos) << panel.rules[0].label;
  EXPECT_LT((*panel.y.range)[0], 1e-7) << "so that the band shows";
  study.mesh_references[0].certified = true;
  EXPECT_EQ(named(study_figures(study), time_work_figure_name).plot.panels[0].rules[0].label.find("not"),
            std::string::npos);
}

TEST(StudyFigures, OfTheTotalSayWhatEachMeshErrsAlone) {
  const Panel panel = named(study_figures(made_study()), total_work_figure_name).plot.panels[0];
  std::vector<double> lines;
  for (const Rule& rule : panel.rules)
    if (rule.from == rule.to) lines.push_back(rule.to);
  EXPECT_EQ(lines, (std::vector<double>{0.016, 0.004, 0.001}));
}

TEST(StudyFigures, OrdersAreInTheLegendAndTheirPartsDrawnWide) {
  const WorkPrecision study = made_study();
  const Figure figure = named(study_figures(study), order_figure_name);
  EXPECT_NO_THROW(labelled(figure, "fourth: 4.00"));
  EXPECT_NO_THROW(labelled(figure, "first: 1.00"));
  std::size_t wide = 0;
  for (const Series& series : figure.plot.panels[0].series)
    wide += series.line_width > 2 && series.x.size() > 2;
  EXPECT_EQ(wide, 3U);
}

TEST(StudyFigures, MeshHasItsEstimates) {
  const Figure figure = named(study_figures(made_study()), mesh_figure_name);
  EXPECT_EQ(labelled(figure, "Richardson's estimate").y, (std::vector<double>{0.00025}));
  EXPECT_EQ(labelled(figure, "grid convergence index").y, (std::vector<double>{0.0003125}));
  EXPECT_EQ(labelled(figure, "to 32 elements").x, (std::vector<double>{4, 8, 16}));
}

// Everything of a study can be laid out and drawn, whatever is missing.
void expect_drawable(const WorkPrecision& study, const std::string& name) {
  const GlContext context;
  PlotRenderer renderer(context);
  for (const Figure& figure : study_figures(study)) {
    EXPECT_NO_THROW(keep(name + "_" + figure.name, renderer.draw(figure.plot))) << name << " " << figure.name;
    EXPECT_EQ(figure.alt.find("nan"), std::string::npos) << figure.alt;
  }
}

TEST(StudyFigures, OfManyCurvesCanBeDrawn) {
  expect_drawable(made_study(), "study");
  MadeCurves many;
  for (int k = 0; k < 24; ++k) {
    many.curve("method " + std::to_string(k), static_cast<MethodFamily>(k % 5), 4, 1 + k % 5, 1 + k,
               1e-7 * (1 + k));
    if (k % 3 == 0) many.failed(Outcome::diverged, "the state is not finite").wrong();
  }
  expect_drawable(many.judged(), "study_many");
}

TEST(StudyFigures, OfFailuresOnlyOfOneRunOnlyAndOfNothingCanBeDrawn) {
  MadeCurves failures;
  failures.curve("never", MethodFamily::structural, 4, 2, 1, 1e-6, 0);
  WorkPrecisionRun run;
  WorkPrecision study = failures.judged();
  for (const double seconds : {-1.0, 0.5}) {
    run.elements = 4;
    run.outcome = Outcome::out_of_time;
    run.message = "out of time at 0.1 s";
    if (seconds > 0) run.seconds = {seconds};
    study.curves[0].runs.push_back(study.runs.size());
    study.runs.push_back(run);
  }
  evaluate(study);
  EXPECT_EQ(points_with(named(study_figures(study), time_work_figure_name), Marker::cross), 2U)
      << "also the one that was not timed";
  expect_drawable(study, "study_failures");

  expect_drawable(MadeCurves().curve("once", MethodFamily::structural, 4, 2, 1, 1e-6, 1).judged(),
                  "study_one");
  expect_drawable(MadeCurves().judged(), "study_mesh_only");
  EXPECT_TRUE(study_figures(WorkPrecision{}).empty());
}

}  // namespace study_figures_test
}  // namespace plumb
