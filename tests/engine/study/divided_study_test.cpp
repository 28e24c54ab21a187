#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
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

// Every kind of study, stopped at a point drawn by lot and gone on with, or divided into shares that are put
// together, comes to the end of one that was not.

namespace plumb {
namespace divided_study_test {

using Json = nlohmann::ordered_json;

constexpr long never = 1L << 40;

const StudyIdentity identity{"of this test", "case.toml", "this program"};

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

/// What cores do to one another is measured, and more points are asked for where it is much.
void take_as_undisturbed(Journal& journal) {
  journal.add("slowdown: in company", "1");
}

/// A study in one piece.
struct Whole {
  Json result;
  long points;
};

Whole whole_of(const Make& make) {
  Journal journal;
  take_as_undisturbed(journal);
  StoppedWorkers workers(never);
  Runner runner(journal, {}, workers);
  Json result = without_times(make(runner));
  return {std::move(result), workers.done()};
}

void expect_same_after_interruption(const Make& make, const Whole& whole, unsigned seed) {
  const auto& [uninterrupted, points] = whole;
  ASSERT_GT(points, 1);

  std::mt19937 draw(seed);
  for (int trial = 0; trial < 2; ++trial) {
    const JournalPath path;
    const long kept = std::uniform_int_distribution<long>(1, points - 1)(draw);
    {
      Journal journal(path.string(), identity);
      take_as_undisturbed(journal);
      StoppedWorkers workers(kept);
      Runner runner(journal, {}, workers);
      EXPECT_THROW(make(runner), Interrupted) << "after " << kept << " of " << points;
    }
    Journal journal(path.string(), identity);
    EXPECT_GE(journal.found(), static_cast<std::size_t>(kept));
    StoppedWorkers rest(never);
    Runner runner(journal, {}, rest);
    const Json again = without_times(make(runner));
    EXPECT_EQ(again, uninterrupted) << "stopped after " << kept << " of " << points << ": "
                                    << Json::diff(uninterrupted, again).dump(1).substr(0, 2000);
    EXPECT_EQ(rest.done(), points - kept) << "a point is computed twice, or none";
  }
}

/// The text of the journal of a share, or of what a list names as missing.
std::string journal_of(const Make& make, Scope scope, const std::string& list = {}) {
  const JournalPath path;
  Journal journal;
  take_as_undisturbed(journal);
  if (!list.empty()) {
    std::ofstream(path.string(), std::ios::binary) << list;
    journal.merge(path.string(), identity);
    scope.only = journal.missing();
  }
  LocalWorkers workers;
  Runner runner(journal, {}, workers, std::move(scope));
  try {
    make(runner);
  } catch (const NotWhole&) {
  }
  return journal.text(identity);
}

/// The study from journals, or nothing where points are missing; `list` is then what names them.
std::optional<Json> merged(const Make& make, const std::vector<std::string>& journals, std::string& list) {
  const JournalPath path;
  Journal journal;
  for (const std::string& text : journals) {
    std::ofstream(path.string(), std::ios::binary) << text;
    journal.merge(path.string(), identity);
  }
  StoppedWorkers none(0);
  Runner runner(journal, {}, none, {.computes = false});
  try {
    return without_times(make(runner));
  } catch (const NotWhole&) {
    list = runner.missing_text(identity);
    return {};
  }
}

void expect_same_from_shares(const Make& make, const Json& undivided, std::size_t shares, unsigned seed) {
  std::mt19937 draw(seed);
  std::vector<std::string> journals;
  for (std::size_t k = 1; k <= shares; ++k)
    journals.push_back(journal_of(make, {.share = k, .shares = shares}));
  std::shuffle(journals.begin(), journals.end(), draw);
  const std::string lost = journals.back();
  journals.pop_back();
  std::string list;
  std::optional<Json> together = merged(make, journals, list);
  if (!together) {
    for (const std::size_t k : {1U, 2U})
      journals.push_back(journal_of(make, {.share = k, .shares = 2}, list));
    std::shuffle(journals.begin(), journals.end(), draw);
    together = merged(make, journals, list);
  }
  ASSERT_TRUE(together) << shares << " shares: still missing: " << list.substr(0, 2000);
  EXPECT_EQ(*together, undivided) << shares
                                  << " shares: " << Json::diff(undivided, *together).dump(1).substr(0, 2000);
  journals.push_back(lost);
  journals.push_back(lost);
  EXPECT_EQ(merged(make, journals, list), undivided) << "with a share that was computed twice";
}

void expect_same_however_computed(const Make& make, unsigned seed) {
  const Whole whole = whole_of(make);
  expect_same_after_interruption(make, whole, seed);
  expect_same_from_shares(make, whole.result, 3, seed);
}

TEST(DividedStudy, OfWorkAndPrecisionGoesOn) {
  LoadedCase loaded = tiny_study_case();
  loaded.spec.work_precision->full.repeats = 1;
  expect_same_however_computed(
      [&](Runner& runner) {
        const WorkPrecision study = run_work_precision(loaded.spec, false, runner);
        return Json{{"runs", encode(study.runs)}, {"mesh error", study.converged_mesh_error}};
      },
      1);
}

TEST(DividedStudy, OfStabilityGoesOn) {
  LoadedCase loaded = tiny_stability_case();
  loaded.spec.stability->methods = {"velocity-verlet", "trapezoidal"};
  expect_same_however_computed(
      [&](Runner& runner) {
        return Json::parse(encode_stability({loaded, run_stability(loaded, runner)}));
      },
      2);
}

TEST(DividedStudy, OfRandomCasesGoesOn) {
  const LoadedCase loaded = tiny_sweep_case({"study.sweep.cases=16", "study.sweep.time_limit=20"});
  expect_same_however_computed(
      [&](Runner& runner) { return Json::parse(encode_sweep(run_sweep(loaded, runner))); }, 3);
}

TEST(DividedStudy, OfVariantsGoesOn) {
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
  expect_same_however_computed(
      [&](Runner& runner) { return Json::parse(encode_variants(run_variants(loaded, runner))); }, 4);
}

TEST(DividedStudy, OfScenesGoesOn) {
  const LoadedCase loaded = tiny_study_case(R"(
[scene]
tolerance = 0.5
[study.economy]
widths = [160, 320]
reference_elements = 4
scenes = 2
)");
  const auto gauge_of = [](const Case& spec) { return tips_along_z(100, spec.scene.frame_rate); };
  expect_same_however_computed(
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
  const Make make = [&](Runner& runner) { return uncertainty_json(run_uncertainty(run, runner)); };
  expect_same_after_interruption(make, whole_of(make), 6);
}

TEST(InterruptedStudy, OfAnErrorBudgetGoesOn) {
  LoadedCase loaded = assessed_run().loaded;
  std::erase_if(loaded.spec.error_budget->items,
                [](const BudgetItemSpec& item) { return item.name == "mesh"; });
  const Make make = [&](Runner& runner) { return budget_json(run_budget(loaded, runner)); };
  expect_same_after_interruption(make, whole_of(make), 7);
}

TEST(DividedStudy, OfSensitivityGoesOn) {
  const LoadedCase loaded = tiny_sensitivity_case("largest = 2\n");
  const Judge judge = tiny_judge(loaded);
  expect_same_however_computed([&](Runner& runner) { return encode(run_sensitivity(loaded, judge, runner)); },
                               8);
}

TEST(DividedStudy, IntoAnyNumberOfSharesIsTheSame) {
  const LoadedCase loaded = tiny_study_case(R"(
[[study.variant]]
name = "as it is"
[[study.variant]]
name = "finer"
set = { method.step = 5e-4 }
[[study.variant]]
name = "coarser"
set = { method.step = 2e-3 }
)");
  const Make make = [&](Runner& runner) {
    return Json::parse(encode_variants(run_variants(loaded, runner)));
  };
  const Whole whole = whole_of(make);
  for (const std::size_t shares : {1U, 2U, 16U}) expect_same_from_shares(make, whole.result, shares, 9);
}

TEST(DividedStudy, IsDealtOutWholeAndOnce) {
  // What a share computes of parts of each kind.
  const std::size_t points = 23, shares = 4;
  std::map<std::string, int> computed;
  for (std::size_t share = 1; share <= shares; ++share) {
    Journal journal;
    LocalWorkers workers;
    Runner runner(journal, {}, workers, {.share = share, .shares = shares});
    const auto part = [&](const Part& part_of, std::size_t count) {
      std::vector<StudyPoint<int>> asked;
      for (std::size_t k = 0; k < count; ++k)
        asked.push_back({fmt::format("{}", k), [] { return 1; }, static_cast<double>(k)});
      return runner.run(part_of, asked);
    };
    part({"shared", Company::alone, Division::shared}, 3);
    const std::vector<int> own = part({"split", Company::alone}, points);
    const auto count = static_cast<std::size_t>(std::count(own.begin(), own.end(), 1));
    EXPECT_LE(count, points / shares + 1);
    for (std::size_t k = 0; k < points; ++k)
      computed[fmt::format("split {}", k)] += journal.find(fmt::format("split: {}", k)) ? 1 : 0;
    EXPECT_EQ(journal.points(), 3 + count) << "share " << share;
    EXPECT_EQ(runner.missing().size(), points - count);
    EXPECT_THROW(runner.conclude(), NotWhole);
  }
  for (const auto& [key, times] : computed) EXPECT_EQ(times, 1) << key;
}

TEST(DividedStudy, KnowsWhoseTimesMayBeHeldAgainstOneAnother) {
  Journal journal;
  const Machine other{"other", "another processor", "r"};
  journal.add("timing: 1", "1", 1, other);
  journal.add("errors: 1", "1", 1, other);
  Runner runner(journal);
  const auto ask = [&](const char* part, int count) {
    std::vector<StudyPoint<int>> asked;
    for (int k = 1; k <= count; ++k) asked.push_back({fmt::format("{}", k), [] { return 1; }});
    runner.run(Part(part), asked);
  };
  ask("errors", 1);
  EXPECT_TRUE(runner.alike({"errors"}));
  ask("timing", 2);
  EXPECT_FALSE(runner.alike({"timing"})) << "one here, one on another processor";
  ask("here", 2);
  EXPECT_TRUE(runner.alike({"here"}));
  EXPECT_FALSE(runner.alike({"here", "errors"}));
}

/// Every second task is computed on another machine.
class UnlikeWorkers : public Workers {
 public:
  void compute(const std::vector<Task>& tasks, Company company, const Take& take) override {
    LocalWorkers().compute(tasks, company, [&](std::size_t task, TaskEnd end) {
      if (task % 2 == 1) end.on = {"far", "another processor", "r"};
      take(task, end);
    });
  }
};

TEST(DividedStudy, OnUnlikeMachinesCountsWorkAndHoldsNoTimesAgainstOneAnother) {
  LoadedCase loaded = tiny_study_case();
  Journal journal;
  UnlikeWorkers workers;
  Runner runner(journal, {}, workers);
  const WorkPrecision study = run_work_precision(loaded.spec, false, runner);
  EXPECT_FALSE(study.timed);
  for (const WorkPrecisionRun& run : study.runs) EXPECT_TRUE(run.seconds.empty()) << run.setting();
  ASSERT_FALSE(study.time_front.empty());
  double before = 0;
  for (const std::size_t k : study.time_front) {
    const auto work = static_cast<double>(study.runs[k].counters.force_evaluations);
    EXPECT_GT(work, before) << "the front is one of force evaluations";
    EXPECT_EQ(study.work(study.runs[k]), work);
    before = work;
  }
  ASSERT_FALSE(study.time_cheapest.empty());
  EXPECT_NE(study.time_cheapest[0].in_words.find("force evaluations"), std::string::npos)
      << study.time_cheapest[0].in_words;
  std::map<std::string, std::string> said;
  for (const auto& [name, value] : study.provenance) said[name] = value;
  EXPECT_NE(said["points computed on far"].find("another processor"), std::string::npos);
}

}  // namespace divided_study_test
}  // namespace plumb
