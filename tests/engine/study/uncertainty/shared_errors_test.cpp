#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/study/uncertainty/explanation.h"
#include "engine/study/uncertainty/uncertainty_parts.h"

namespace plumb {
namespace shared_errors_test {

constexpr std::size_t count = 40;  // times of a case, from 0 to 1 s

/// A smooth function of time that is 0 at the start: an error that grows and swings.
class Swing {
 public:
  explicit Swing(std::mt19937_64& draw) {
    for (double& a : amplitude_) a = normal_(draw);
    for (double& p : phase_) p = angle_(draw);
  }

  double operator()(double t) const {
    double sum = 0;
    for (std::size_t k = 0; k < amplitude_.size(); ++k)
      sum += amplitude_[k] * std::sin((2 + 3 * static_cast<double>(k)) * t + phase_[k]);
    return t * sum;
  }

 private:
  std::normal_distribution<double> normal_{};
  std::uniform_real_distribution<double> angle_{0, 6.28};
  std::array<double, 3> amplitude_{}, phase_{};
};

/// A comparison whose true errors are known: what meshes, the time integration behind the data, the input and
/// rounding do to a run and to the figures. Nothing else differs, so that E is of these alone.
struct Made {
  SeriesUncertainty series;
  double share_within() const { return series.share_within; }
};

Made made_comparison(std::mt19937_64& draw, bool same_mesh, bool counts_as_shared) {
  const Swing mesh_error(draw), data_error(draw), input_effect(draw);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double order = 2 + 1.5 * std::abs(uniform(draw)), size_of_mesh = 0.02, size_of_data = 0.004,
               spread = 0.003, rounding = 1e-5, input = normal(draw);
  const auto mesh_at = [&](double t, double elements) {
    // What goes on top of the leading term makes the observed order another than the true one.
    const double h = 4 / elements;
    return size_of_mesh * mesh_error(t) * (std::pow(h, order) + 0.1 * std::pow(h, order + 1));
  };
  Made made;
  std::array<ColumnValues, 3> meshes;
  std::vector<ColumnValues> samples(24);
  std::vector<double> inputs(samples.size());
  for (double& x : inputs) x = normal(draw);
  std::vector<double> known;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k + 1) / count;
    made.series.times.push_back(t);
    const double run = mesh_at(t, 4);
    const double figure = (same_mesh ? mesh_at(t, 4) : 0) + size_of_data * data_error(t) +
                          spread * input * input_effect(t) + rounding * uniform(draw);
    made.series.error.push_back(run - figure);
    known.push_back(size_of_data * data_error(t));
    for (std::size_t m = 0; m < meshes.size(); ++m)
      meshes[m].values.push_back(mesh_at(t, m == 0 ? 16 : m == 1 ? 8 : 4));
    for (std::size_t s = 0; s < samples.size(); ++s)
      samples[s].values.push_back(spread * inputs[s] * input_effect(t));
  }
  ReferenceSeries data;
  data.uncertainty = rounding;
  made.series.parts = {
      counts_as_shared ? shared_mesh_part(4) : mesh_part({{16, 8, 4}, OfThree::coarsest}, meshes),
      input_part(1, 1, samples), data_part(data, count, {{"time integration", known}})};
  conclude(made.series);
  return made;
}

double coverage(bool same_mesh, bool counts_as_shared, int cases) {
  std::mt19937_64 draw(7);
  double sum = 0;
  for (int k = 0; k < cases; ++k)
    sum += made_comparison(draw, same_mesh, counts_as_shared).share_within() / cases;
  return sum;
}

TEST(SharedErrors, TwiceTheUncertaintyCoversErrorsThatAreKnown) {
  constexpr int cases = 600;
  const double shared = coverage(true, true, cases), apart = coverage(false, false, cases);
  for (const double covered : {shared, apart}) {
    EXPECT_GT(covered, 0.90) << "shared mesh " << shared << ", apart " << apart;
    EXPECT_LT(covered, 0.99) << "shared mesh " << shared << ", apart " << apart;
  }
}

TEST(SharedErrors, AMeshThatIsNotSharedMustNotBeLeftOut) {
  constexpr int cases = 200;
  const double covered = coverage(false, true, cases);
  EXPECT_LT(covered, 0.7) << "the error of the mesh is in E and not in u";
}

/// A comparison at three times, of which E is 0.1 m at the last two.
SeriesUncertainty beyond() {
  SeriesUncertainty series;
  series.series = "y";
  series.unit = "m";
  series.times = {0, 1, 2};
  series.error = {0, 0.1, -0.1};
  series.parts = {{"data", PartState::estimated, "made", {0.01, 0.01, 0.01}}};
  conclude(series);
  return series;
}

BudgetEntry item(const std::string& name, std::vector<double> difference, bool of_run = true) {
  BudgetEntry entry;
  entry.name = name;
  entry.of_run = of_run;
  entry.run.outcome = Outcome::completed;
  entry.run.distances = {{"y", 0, {}, std::move(difference)}};
  return entry;
}

TEST(Explanation, NamesTheItemThatLeavesLeastOfTheError) {
  ErrorBudget budget;
  budget.times = {0, 1, 2};
  budget.entries = {item("gravity", {0, 0.01, 0.02}), item("start", {0.3, 0.09, -0.1}),
                    item("strain", {0, 0.1, -0.1}, false)};
  EXPECT_EQ(explanation(budget, beyond()),
            "accounted for by the start of the error budget, but for 7 %: without that the run is within 2 u "
            "at 2 of "
            "these 2 times")
      << "the strain is no difference of the run";
}

TEST(Explanation, AddsItemsUntilHalfIsAccountedForAndSaysWhereNothingDoes) {
  ErrorBudget budget;
  budget.times = {0, 1, 2};
  budget.entries = {item("start", {0, 0.1, 0}), item("gravity", {0, 0, -0.08})};
  EXPECT_NE(explanation(budget, beyond()).find("by the start and the gravity of"), std::string::npos)
      << explanation(budget, beyond());
  budget.entries.pop_back();
  EXPECT_EQ(explanation(budget, beyond()), "nothing in the error budget accounts for half of it");
  budget.entries = {item("start", {0, 0.1})};
  EXPECT_EQ(explanation(budget, beyond()), "nothing in the error budget accounts for half of it")
      << "the item has no value at the last time";
  SeriesUncertainty within = beyond();
  within.beyond.clear();
  EXPECT_EQ(explanation(budget, within), "");
}

}  // namespace shared_errors_test
}  // namespace plumb
