#include <gtest/gtest.h>

#include <random>

#include "engine/base/errors.h"
#include "engine/integrate/integrate.h"
#include "engine/study/economy/economy_study_json.h"
#include "engine/study/economy/run_economy.h"
#include "engine/study/sensitivity/sensitivity_members.h"
#include "engine/study/sweep/run_sweep.h"
#include "engine/study/sweep/sweep_json.h"
#include "engine/study/uncertainty/budget_json.h"
#include "engine/study/uncertainty/run_budget.h"
#include "engine/study/uncertainty/run_uncertainty.h"
#include "engine/study/uncertainty/uncertainty_json.h"
#include "engine/study/variants/run_variants.h"
#include "engine/study/variants/variants_file.h"
#include "engine/study/work_precision/work_precision_members.h"
#include "tests/engine/study/economy/tips_along_z.h"
#include "tests/engine/study/journal_file.h"
#include "tests/engine/study/sensitivity/tiny_sensitivity.h"
#include "tests/engine/study/stability/tiny_stability.h"
#include "tests/engine/study/sweep/tiny_sweep.h"
#include "tests/engine/study/work_precision/tiny_study.h"

// Every kind of study, stopped at a point drawn by lot and gone on with, comes to the end of one that was
// not.

namespace plumb {
namespace interrupted_study_test {

using Json = nlohmann::ordered_json;

constexpr long never = 1L << 40;

/// Stops the study when it has computed so many points.
class StoppedWorkers : public Workers {
 public:
  explicit StoppedWorkers(long left) : left_(left) {}

  void compute(const std::vector<Task>& tasks, Company company, const Take& take) override {
    LocalWorkers().compute(tasks, company, [&](std::size_t task, const TaskEnd& end) {
      if (left_ == 0) throw Interrupted();
      --left_;
      ++done_;
      take(task, end);
    });
  }
  long done() const { return done_; }

 private:
  long left_;
  long done_ = 0;
};

using Make = std::function<Json(Runner& runner)>;

/// Takes out times, which differ from one run to the next.
Json without_times(Json json) {
  if (json.is_object()) {
    std::vector<std::string> times;
    for (const auto& [key, value] : json.items())
      if (key.find("seconds") != key.npos || key == "provenance" || key == "check_sum") times.push_back(key);
    for (const std::string& key : times) json.erase(key);
  }
  if (json.is_structured())
    for (Json& value : json) value = without_times(value);
  return json;
}

void expect_same_after_interruption(const Make& make, unsigned seed) {
  Journal none;
  StoppedWorkers all(never);
  Runner whole(none, {}, all);
  const Json uninterrupted = without_times(make(whole));
  ASSERT_GT(all.done(), 1);

  std::mt19937 draw(seed);
  for (int trial = 0; trial < 2; ++trial) {
    const JournalPath path;
    const long kept = std::uniform_int_distribution<long>(1, all.done() - 1)(draw);
    {
      Journal journal(path.string(), "of this test");
      StoppedWorkers workers(kept);
      Runner runner(journal, {}, workers);
      EXPECT_THROW(make(runner), Interrupted) << "after " << kept << " of " << all.done();
    }
    Journal journal(path.string(), "of this test");
    EXPECT_GE(journal.found(), static_cast<std::size_t>(kept));
    StoppedWorkers rest(never);
    Runner runner(journal, {}, rest);
    const Json again = without_times(make(runner));
    EXPECT_EQ(again, uninterrupted) << "stopped after " << kept << " of " << all.done() << ": "
                                    << Json::diff(uninterrupted, again).dump(1).substr(0, 2000);
    EXPECT_EQ(rest.done(), all.done() - kept) << "a point is computed twice, or none";
  }
}

TEST(InterruptedStudy, OfWorkAndPrecisionGoesOn) {
  LoadedCase loaded = tiny_study_case();
  loaded.spec.work_precision->full.repeats = 1;
  expect_same_after_interruption(
      [&](Runner& runner) {
        const WorkPrecision study = run_work_precision(loaded.spec, false, runner);
        return Json{{"runs", encode(study.runs)}, {"mesh error", study.converged_mesh_error}};
      },
      1);
}

TEST(InterruptedStudy, OfStabilityGoesOn) {
  LoadedCase loaded = tiny_stability_case();
  loaded.spec.stability->methods = {"velocity-verlet", "trapezoidal"};
  expect_same_after_interruption(
      [&](Runner& runner) {
        return Json::parse(encode_stability({loaded, run_stability(loaded, runner)}));
      },
      2);
}

TEST(InterruptedStudy, OfRandomCasesGoesOn) {
  const LoadedCase loaded = tiny_sweep_case({"study.sweep.cases=24", "study.sweep.time_limit=20"});
  expect_same_after_interruption(
      [&](Runner& runner) { return Json::parse(encode_sweep(run_sweep(loaded, runner))); }, 3);
}

TEST(InterruptedStudy, OfVariantsGoesOn) {
  const LoadedCase loaded = tiny_study_case(R"(
[[study.variant]]
name = "as it is"
[[study.variant.expect]]
quantity = "distance"
from = "finer"
value = 0
within = 1e-3
source = "the same motion"
[[study.variant]]
name = "finer"
set = { method.step = 5e-4 }
[[study.variant]]
name = "too long a step"
set = { method.step = 0.01 }
)");
  expect_same_after_interruption(
      [&](Runner& runner) { return Json::parse(encode_variants(run_variants(loaded, runner))); }, 4);
}

TEST(InterruptedStudy, OfScenesGoesOn) {
  const LoadedCase loaded = tiny_study_case(R"(
[scene]
tolerance = 0.5
[study.economy]
widths = [160, 320]
reference_elements = 4
scenes = 3
)");
  const auto gauge_of = [](const Case& spec) { return tips_along_z(100, spec.scene.frame_rate); };
  expect_same_after_interruption(
      [&](Runner& runner) {
        Json json = Json::parse(encode_economy_study(run_economy(loaded, gauge_of, runner)));
        json.erase("safe_end");  // reached in the time allowed
        return json;
      },
      5);
}

/// A tenth of a second of the pendulum, with its references, uncertain inputs and budget.
Run assessed_run() {
  Run run;
  run.loaded = load_case(std::string(PLUMB_SOURCE_DIR) + "/cases/pendulum.toml",
                         {"time.end=0.1", "method.rtol=1e-7", "uncertainty.samples=4"});
  run.trajectory = integrate(run.loaded.spec);
  run.probes = probe(run.loaded.spec, run.trajectory);
  return run;
}

TEST(InterruptedStudy, OfUncertaintyGoesOn) {
  const auto run = assessed_run();
  expect_same_after_interruption(
      [&](Runner& runner) { return uncertainty_json(run_uncertainty(run, runner)); }, 6);
}

TEST(InterruptedStudy, OfAnErrorBudgetGoesOn) {
  LoadedCase loaded = assessed_run().loaded;
  std::erase_if(loaded.spec.error_budget->items,
                [](const BudgetItemSpec& item) { return item.name == "mesh"; });
  expect_same_after_interruption([&](Runner& runner) { return budget_json(run_budget(loaded, runner)); }, 7);
}

TEST(InterruptedStudy, OfSensitivityGoesOn) {
  const LoadedCase loaded = tiny_sensitivity_case("largest = 2\n");
  const Judge judge = tiny_judge(loaded);
  expect_same_after_interruption(
      [&](Runner& runner) { return encode(run_sensitivity(loaded, judge, runner)); }, 8);
}

}  // namespace interrupted_study_test
}  // namespace plumb
