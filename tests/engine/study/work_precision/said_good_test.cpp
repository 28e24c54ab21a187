#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/study/economy/economy_study.h"
#include "engine/study/reference/certified_reference.h"
#include "engine/study/reference/classify_outcome.h"
#include "engine/study/reference/error_norms.h"
#include "engine/study/reference/grid_convergence.h"
#include "engine/study/reference/mesh_index.h"
#include "engine/study/reference/node_distance.h"
#include "engine/study/stability/step_in_words.h"
#include "engine/study/sweep/sweep.h"
#include "engine/study/uncertainty/uncertainty_parts.h"
#include "engine/study/variants/variant_figure.h"
#include "engine/study/work_precision/common_floors.h"
#include "engine/study/work_precision/observed_order.h"
#include "engine/study/work_precision/pareto.h"

// What each place that can say something good says of nothing, of one point, of what is not a number, of
// what is infinite and of what is another thing.
namespace plumb {
namespace said_good_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();

/// One element that lies along x, its last node moved by `moved` along y at each output after the first.
Trajectory motion(std::vector<double> times, double moved, int elements = 1) {
  Trajectory t;
  t.outcome = Outcome::completed;
  t.elements = elements;
  t.element_length = 1.0 / elements;
  for (std::size_t k = 0; k < times.size(); ++k) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6 * (elements + 1));
    for (int node = 0; node <= elements; ++node) q[6 * node] = node * t.element_length, q[6 * node + 3] = 1;
    if (k > 0) q[6 * elements + 1] = moved;
    t.q.push_back(q);
    t.v.push_back(0 * q);
    t.energies.push_back({1, 0, 0, 0});
  }
  t.times = std::move(times);
  t.end_time = t.times.empty() ? 0 : t.times.back();
  return t;
}

std::string judged(const Trajectory& run, const Trajectory& reference, double tolerance, double horizon) {
  return std::string(word(classify_outcome(run, reference, tolerance, horizon).outcome));
}

const Trajectory& whole() {
  static const Trajectory made = motion({0, 1, 2}, 0);
  return made;
}

std::string certified(double agreement, double smallest_error, double mesh_error) {
  CertifiedReference reference;
  reference.agreement = agreement;
  certify(reference, smallest_error, mesh_error);
  return reference.certified ? "certified" : reference.why_not.substr(0, 20);
}

std::string swept(double second_error, double disagreement) {
  SweepRun run;
  run.outcome = Outcome::accurate;
  run.second_error = second_error;
  run.disagreement = disagreement;
  return run.wrongly_accurate(0.1) ? "wrong" : "right";
}

std::string order_of(const GridConvergence& found) {
  return found.order < 0 && found.error < 0 && found.index < 0 ? "unknown"
                                                               : fmt::format("{:.1f}", found.order);
}

std::string indexed(const std::vector<double>& fine, const std::vector<double>& medium,
                    const std::vector<double>& coarse) {
  const MeshIndex found = mesh_index(fine, medium, coarse, OfThree::finest);
  return found.order < 0 && found.values.empty() ? "unknown" : fmt::format("{:.1f}", found.order);
}

std::string ordered(const std::vector<StepError>& curve, double floor = 0, double ceiling = 1) {
  const double order = observed_order(curve, floor, ceiling).order;
  return order < 0 ? "unknown" : fmt::format("{:.1f}", order);
}

std::string front(const std::vector<WorkError>& runs) {
  return std::to_string(pareto_front(runs).size());
}

std::string mesh(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c) {
  const UncertaintyPart part = mesh_part({{8, 4, 2}, OfThree::finest},
                                         {ColumnValues{a, ""}, ColumnValues{b, ""}, ColumnValues{c, ""}});
  return part.state == PartState::estimated ? "estimated" : "not estimated";
}

std::string mesh_of_two() {
  const UncertaintyPart part =
      mesh_part({{8, 4, 2}, OfThree::finest},
                {ColumnValues{{1}, ""}, ColumnValues{{1}, ""}, ColumnValues{{}, "it failed"}});
  return part.state == PartState::estimated ? "estimated" : "not estimated";
}

/// The greatest that half the step says of the error of a step.
std::string time(const std::vector<double>& run, const ColumnValues& finer) {
  MethodSpec method;
  method.name = "rk4";
  method.step = 1e-3;
  const UncertaintyPart part = time_part(method, run, finer);
  if (part.state != PartState::estimated || part.values.empty()) return "not estimated";
  return fmt::format("{:.2g}", part.values.back());
}

std::string sampled(const std::vector<double>& samples) {
  std::vector<ColumnValues> columns;
  for (const double value : samples) columns.push_back({{value}, ""});
  const UncertaintyPart part = input_part(1, 1, columns);
  return part.state == PartState::estimated ? fmt::format("{:.2g}", part.values.front()) : "not estimated";
}

std::string compared(double error, double uncertainty) {
  SeriesUncertainty series;
  series.unit = "m";
  series.times = {1};
  series.error = {error};
  series.parts = {{"mesh", PartState::estimated, "made", {uncertainty}}};
  conclude(series);
  return fmt::format("{:.0f} within, {}", series.share_within, series.finding);
}

std::string met(double found, double value = 0, double within = 1) {
  ExpectationFound figure;
  figure.found = found;
  figure.expected.value = value;
  figure.expected.within = within;
  return figure.met() ? "met" : "not met";
}

VariantResult variant(const std::string& name, Trajectory run, std::vector<double> column = {}) {
  VariantResult made;
  made.spec.name = name;
  made.run.probes = {{"tip", 1, Quantity::position}};
  made.probes.times = run.times;
  made.probes.columns = {{"tip.x", "m", std::move(column)}};
  made.trajectory = std::move(run);
  return made;
}

std::string figure(const std::string& quantity, const VariantResult& of, const VariantResult& other) {
  ExpectationSpec expected;
  expected.quantity = quantity;
  expected.from = other.spec.name;
  const double found = find_figure(expected, of, {of, other}).found;
  return std::isnan(found) ? "none" : fmt::format("{:g}", found);
}

std::string apart(const Trajectory& a, const Trajectory& b) {
  return figure("distance", variant("a", a), variant("b", b));
}

std::string step_of(std::vector<Outcome> outcomes) {
  OutcomeMap map;
  for (std::size_t k = 0; k < outcomes.size(); ++k) map.settings.push_back(1e-3 * std::pow(2, k));
  map.points.resize(outcomes.size());
  for (std::size_t k = 0; k < outcomes.size(); ++k) map.points[k].outcome = outcomes[k];
  return step_in_words(map, 0);
}

SceneNeed need(double estimate, double true_error, double doubt) {
  SceneNeed made;
  made.reference_doubt = doubt;
  TriedCandidate candidate;
  candidate.estimate = estimate;
  candidate.true_error = true_error;
  made.economy.tried = {candidate};
  return made;
}

std::string proven(double estimate, double true_error, double doubt) {
  const SceneNeed made = need(estimate, true_error, doubt);
  return made.proven_candidates() == 0 ? "nothing proven" : fmt::format("{:g}", made.worst_ratio());
}

std::string scene(double true_error, double doubt) {
  RandomScene made;
  made.holds = true;
  made.tolerance = 1;
  made.true_error = true_error;
  made.reference_doubt = doubt;
  return made.missed() ? "missed" : "met";
}

struct Row {
  const char* sentence;
  std::string said, right;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"a run within its tolerance is accurate", judged(motion({0, 1, 2}, 0.1), whole(), 0.2, 2), "accurate"},
      {"a run of no outputs is not judged", judged(motion({}, 0), whole(), 0.2, 2), "completed"},
      {"a run is not judged by no outputs", judged(whole(), motion({}, 0), 0.2, 2), "completed"},
      {"a run is not judged by its start", judged(motion({0, 1, 2}, 9), motion({0}, 0), 0.2, 2), "completed"},
      {"a run of its start alone is not judged", judged(motion({0}, 0), whole(), 0.2, 2), "completed"},
      {"a run is not judged where neighbours part at once", judged(motion({0, 1, 2}, 9), whole(), 0.2, 0),
       "completed"},
      {"a run is not judged before its first output", judged(motion({0, 1, 2}, 9), whole(), 0.2, 0.5),
       "completed"},
      {"a run is not judged up to a time that is none", judged(motion({0, 1, 2}, 9), whole(), 0.2, nan),
       "completed"},
      {"a run is not judged by other times", judged(motion({0, 1, 2}, 0), motion({0, 1.1, 2}, 0), 0.2, 2),
       "completed"},
      {"a run is not judged by another mesh", judged(motion({0, 1, 2}, 0), motion({0, 1, 2}, 0, 2), 0.2, 2),
       "completed"},
      {"a run that is not a number is inaccurate", judged(motion({0, 1, 2}, nan), whole(), 0.2, 2),
       "inaccurate"},
      {"a run that is infinite is inaccurate by any tolerance",
       judged(motion({0, 1, 2}, inf), whole(), inf, 2), "inaccurate"},
      {"a run is inaccurate by a tolerance that is none", judged(whole(), whole(), nan, 2), "inaccurate"},

      {"an accurate run that both references confirm is right", swept(0.1, 0.01), "right"},
      {"an accurate run without a second reference is wrong", swept(-1, 0.01), "wrong"},
      {"an accurate run between references that are not compared is wrong", swept(0.05, -1), "wrong"},
      {"an accurate run is wrong by a distance that is none", swept(nan, 0.01), "wrong"},
      {"an accurate run is wrong by references that differ by no number", swept(0.05, nan), "wrong"},
      {"an accurate run is wrong by references that differ without end", swept(0.05, inf), "wrong"},
      {"an accurate run infinitely far off is wrong", swept(inf, inf), "wrong"},

      {"a reference ten times better than what is drawn is certified", certified(1e-10, 1e-6, 0),
       "certified"},
      {"a reference that failed is not certified", certified(-1, 1e-6, 0), "no two methods compl"},
      {"a reference is not certified by an agreement that is none", certified(nan, 1e-6, 0),
       "no two methods compl"},
      {"a reference is not certified by an infinite agreement", certified(inf, inf, 0),
       "no two methods compl"},
      {"a reference that nothing was held against is not certified", certified(1e-10, -1, 0),
       "no run has an error "},
      {"a reference is not certified by an error that is none", certified(1e-10, nan, 0),
       "no run has an error "},
      {"a reference is not certified by an infinite error", certified(1e-10, inf, 0), "no run has an error "},
      {"a reference on a mesh whose error is no number is not certified", certified(1e-10, 1e-6, nan),
       "the error of its mes"},

      {"two runs of their start alone have no distance",
       fmt::format("{}", error_norms(motion({0}, 0), motion({0}, 0)).tip_max), "-1"},
      {"two runs without outputs have no distance",
       fmt::format("{}", error_norms(motion({}, 0), motion({}, 0)).tip_max), "-1"},
      {"two runs at other times have no distance",
       fmt::format("{}", error_norms(motion({0, 1}, 0), motion({0, 2}, 0)).tip_max), "-1"},
      {"the distance to what is not a number is none",
       fmt::format("{}", std::isnan(error_norms(motion({0, 1, 2}, nan), whole()).tip_max)), "true"},
      {"neighbours without outputs are never together",
       fmt::format("{}", together_until(motion({}, 0), whole(), 1)), "-1"},
      {"neighbours part where one is not a number",
       fmt::format("{}", together_until(motion({0, 1, 2}, nan), whole(), 1)), "0"},

      {"three meshes with falling changes have an order", order_of(grid_convergence(1, 4, 2, 2, 1.25)),
       "2.0"},
      {"three equal meshes have no order", order_of(grid_convergence(0, 0, 2, 2, 1.25)), "unknown"},
      {"a change that is not a number has no order", order_of(grid_convergence(nan, 4, 2, 2, 1.25)),
       "unknown"},
      {"a coarse change that is not a number has no order", order_of(grid_convergence(1, nan, 2, 2, 1.25)),
       "unknown"},
      {"an infinite change has no order", order_of(grid_convergence(1, inf, 2, 2, 1.25)), "unknown"},
      {"an infinite fine change has no order", order_of(grid_convergence(inf, 4, 2, 2, 1.25)), "unknown"},
      {"a mesh that is not refined has no order", order_of(grid_convergence(1, 4, 1, 1, 1.25)), "unknown"},
      {"an index needs a time", indexed({}, {}, {}), "unknown"},
      {"an index of three equal meshes is unknown", indexed({1}, {1}, {1}), "unknown"},
      {"an index of what is not a number is unknown", indexed({0, nan}, {0, 1}, {0, 4}), "unknown"},
      {"a number that follows what is none does not mend it", indexed({0, nan, 0}, {0, 1, 1}, {0, 5, 5}),
       "unknown"},

      {"no runs have no order", ordered({}), "unknown"},
      {"one run has no order", ordered({{1e-2, 1e-2}}), "unknown"},
      {"two runs have no order", ordered({{1e-2, 1e-2}, {5e-3, 2.5e-3}}), "unknown"},
      {"three runs have an order", ordered({{1e-2, 1e-2}, {5e-3, 2.5e-3}, {2.5e-3, 6.25e-4}}), "2.0"},
      {"runs that are not numbers have no order", ordered({{1e-2, nan}, {5e-3, nan}, {2.5e-3, nan}}),
       "unknown"},
      {"runs infinitely far off have no order", ordered({{1e-2, inf}, {5e-3, inf}, {2.5e-3, inf}}),
       "unknown"},
      {"a floor that is not a number leaves no order",
       ordered({{1e-2, 1e-2}, {5e-3, 2.5e-3}, {2.5e-3, 6.25e-4}}, nan), "unknown"},
      {"of no runs none is best", front({}), "0"},
      {"one run is best", front({{1, 1}}), "1"},
      {"what is not a number is never best", front({{nan, 1}, {1, nan}, {inf, 0}, {0, inf}, {-1, -1}}), "0"},
      {"infinite errors are no common floor",
       std::to_string(
           common_floors({{"a", {inf, inf, inf}}, {"b", {inf, inf, inf}}, {"c", {inf, inf, inf}}}).size()),
       "0"},

      {"three meshes that agree to rounding are estimated", mesh({1, 1}, {1, 1}, {1, 1}), "estimated"},
      {"three meshes at no time are not estimated", mesh({}, {}, {}), "not estimated"},
      {"what is not a number on every mesh is not estimated", mesh({nan}, {nan}, {nan}), "not estimated"},
      {"what is infinite on every mesh is not estimated", mesh({inf}, {inf}, {inf}), "not estimated"},
      {"two meshes are not estimated", mesh_of_two(), "not estimated"},
      {"a step is estimated by half of it", time({0, 1}, {{0, 1}, ""}), "0"},
      {"a step is not estimated without half of it", time({0, 1}, {{}, "it failed"}), "not estimated"},
      {"a step is not estimated at no time", time({}, {{}, ""}), "not estimated"},
      {"a step of what is not a number has no estimate that holds", time({0, 1}, {{0, nan}, ""}), "nan"},
      {"a step is not held once it was not a number", time({0, 1, 1}, {{0, nan, 1}, ""}), "nan"},
      {"inputs are sampled", sampled({1, 3}), "1.4"},
      {"one sample of an input says nothing", sampled({1}), "not estimated"},
      {"no sample of an input says nothing", sampled({}), "not estimated"},
      {"samples that are not numbers spread by no number", sampled({1, nan}), "nan"},
      {"an error within its uncertainty is not distinguishable", compared(1, 1),
       "1 within, not distinguishable at this uncertainty"},
      {"an error that is not a number is not within", compared(nan, 1),
       "0 within, nothing can be said: it is not a number"},
      {"an infinite error is not within an infinite uncertainty", compared(inf, inf),
       "0 within, nothing can be said: it is not a number"},
      {"an uncertainty that is not a number holds nothing", compared(0, nan),
       "0 within, nothing can be said: it is not a number"},

      {"a figure at its margin is met", met(1), "met"},
      {"a figure that is not a number is not met", met(nan), "not met"},
      {"an infinite figure is not met", met(inf), "not met"},
      {"an infinite figure is not even the infinite one", met(inf, inf), "not met"},
      {"a figure is not met by a margin that is none", met(0, 0, nan), "not met"},
      {"two variants have a distance", apart(motion({0, 1, 2}, 0.5), whole()), "0.5"},
      {"two variants have no distance at their start alone", apart(motion({0}, 0), whole()), "none"},
      {"two variants have no distance at other times", apart(motion({0.5, 1.5}, 0), whole()), "none"},
      {"two variants have no distance where one ends before the other", apart(motion({0, 1}, 0), whole()),
       "none"},
      {"two variants have no distance on other meshes", apart(motion({0, 1, 2}, 0, 2), whole()), "none"},
      {"two variants have no distance where one is not a number", apart(motion({0, 1, 2}, nan), whole()),
       "none"},
      {"a column with a hole has no greatest",
       figure("greatest tip.x", variant("a", whole(), {1, nan, 3}), variant("b", whole())), "none"},
      {"a column without values has no last",
       figure("tip.x", variant("a", whole(), {}), variant("b", whole())), "none"},

      {"no step is accurate where none was tried", step_of({}), "no step was tried"},
      {"one step is not all steps", step_of({Outcome::accurate}),
       "accurate at the only step that was tried, 1.0e-3 s"},
      {"steps that were not judged are not accurate", step_of({Outcome::completed, Outcome::completed}),
       "accurate at none of the steps from 1.0e-3 s to 2.0e-3 s; completed at 1.0e-3 s"},
      {"an unstable equilibrium is not stable",
       is_stable(Outcome::unstable_equilibrium) ? "stable" : "not stable", "not stable"},

      {"an estimate below the truth is told", proven(1, 3, 0.5), "2.5"},
      {"without an estimate nothing is proven", proven(-1, 3, 0.5), "nothing proven"},
      {"an infinite estimate proves nothing", proven(inf, 3, 0.5), "nothing proven"},
      {"an estimate that is not a number proves nothing", proven(nan, 3, 0.5), "nothing proven"},
      {"without a truth nothing is proven", proven(1, -1, 0.5), "nothing proven"},
      {"a truth that may be off without end proves nothing", proven(1, 3, inf), "nothing proven"},
      {"a truth of unknown doubt proves nothing", proven(1, 3, -1), "nothing proven"},
      {"a scene within its tolerance is met", scene(0.5, 0.01), "met"},
      {"a scene of unknown truth is missed", scene(-1, 0.01), "missed"},
      {"a scene whose truth is not a number is missed", scene(nan, 0.01), "missed"},
      {"a scene whose truth may be off without end is missed", scene(0.5, inf), "missed"},
      {"a scene whose truth was not made is missed", scene(0.5, -1), "missed"},
  };
  return all;
}

class SaidGood : public ::testing::TestWithParam<std::size_t> {};

TEST_P(SaidGood, OnlyOfWhatIs) {
  const Row& row = rows()[GetParam()];
  EXPECT_EQ(row.said, row.right) << row.sentence;
}

INSTANTIATE_TEST_SUITE_P(Engine, SaidGood, ::testing::Range<std::size_t>(0, rows().size()),
                         [](const auto& row) {
                           std::string name = rows()[row.param].sentence;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace said_good_test
}  // namespace plumb
