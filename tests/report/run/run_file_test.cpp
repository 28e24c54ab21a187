#include "engine/run/run_file.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <limits>

#include "engine/base/errors.h"
#include "tests/report/made_run.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace run_file_test {

TEST(RunFile, KeepsEveryNumberOfARun) {
  const TemporaryFolder folder;
  plumb::Run run = run_with("a");
  run.provenance = {{"program", "test"}};
  run.trajectory.counters.steps = 17;
  run.trajectory.solve_seconds = 0.25;
  write_text(folder / "run.h5", encode_run(run));
  const plumb::Run back = read_run((folder / "run.h5").string());
  EXPECT_EQ(back.trajectory.times, run.trajectory.times);
  EXPECT_EQ(back.trajectory.q, run.trajectory.q);
  EXPECT_EQ(back.trajectory.v, run.trajectory.v);
  EXPECT_EQ(back.trajectory.counters.steps, 17);
  EXPECT_EQ(back.trajectory.counters.newton_iterations, -1);
  EXPECT_EQ(back.trajectory.solve_seconds, 0.25);
  EXPECT_EQ(back.trajectory.outcome, Outcome::completed);
  EXPECT_EQ(back.provenance, run.provenance);
  EXPECT_EQ(back.loaded.spec, run.loaded.spec);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(back.trajectory.energies[k].axial, run.trajectory.energies[k].axial);
  EXPECT_EQ(to_csv(back.probes), to_csv(run.probes));
}

plumb::Run run_with_equilibria() {
  plumb::Run run = run_with("a");
  Equilibria& equilibria = run.trajectory.equilibria;
  equilibria.negative_eigenvalues = {0, 2, -1};
  equilibria.path = {{0, 0, 0, true}, {0.5, 1e-3, 0, true}, {0.75, 0.25, 2, false}};
  equilibria.critical_points = {
      {CriticalKind::bifurcation, 0.6, 2e-3, 0, 2, 0.5, {0, 1, 0}, "onto the stable branch"}};
  return run;
}

TEST(RunFile, KeepsThePathOfEquilibriaWhereThereIsOne) {
  const TemporaryFolder folder;
  const plumb::Run run = run_with_equilibria();
  write_text(folder / "run.h5", encode_run(run));
  const Equilibria back = read_run((folder / "run.h5").string()).trajectory.equilibria;
  EXPECT_EQ(back.negative_eigenvalues, run.trajectory.equilibria.negative_eigenvalues);
  ASSERT_EQ(back.path.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const PathPoint &was = run.trajectory.equilibria.path[k], &is = back.path[k];
    EXPECT_EQ(is.load, was.load);
    EXPECT_EQ(is.displacement, was.displacement);
    EXPECT_EQ(is.negative, was.negative);
    EXPECT_EQ(is.joined, was.joined);
  }
  ASSERT_EQ(back.critical_points.size(), 1U);
  const CriticalPoint& point = back.critical_points.front();
  EXPECT_EQ(word(point.kind), "bifurcation");
  EXPECT_EQ(point.load, 0.6);
  EXPECT_EQ(point.negative_after, 2);
  EXPECT_EQ(point.direction[1], 1);
  EXPECT_EQ(point.what_followed, "onto the stable branch");
  write_text(folder / "other.h5", encode_run(run_with("a")));
  EXPECT_TRUE(read_run((folder / "other.h5").string()).trajectory.equilibria.path.empty());
}

TEST(RunFile, IsRefusedWithEquilibriaThatAreNotOneAnOutput) {
  const TemporaryFolder folder;
  plumb::Run run = run_with_equilibria();
  run.trajectory.equilibria.negative_eigenvalues.pop_back();
  write_text(folder / "run.h5", encode_run(run));
  try {
    read_run((folder / "run.h5").string());
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("equilibria are not one an output"), std::string::npos)
        << error.what();
  }
}

plumb::Run run_with_joint() {
  plumb::Run run = run_with("a", "[supports]\nfirst = \"pinned\"\n");
  for (const double force : {1.0, 2.5, -3.0})
    run.trajectory.multipliers.push_back(Eigen::Vector3d(0, force, 0.5));
  run.trajectory.constraint_drift = 1e-15;
  return run;
}

TEST(RunFile, KeepsTheMultipliersOfAJointWhereThereAreAny) {
  const TemporaryFolder folder;
  const plumb::Run run = run_with_joint();
  write_text(folder / "run.h5", encode_run(run));
  const plumb::Run back = read_run((folder / "run.h5").string());
  EXPECT_EQ(back.trajectory.multipliers, run.trajectory.multipliers);
  EXPECT_EQ(back.trajectory.constraint_drift, 1e-15);
  write_text(folder / "other.h5", encode_run(run_with("a")));
  const plumb::Run other = read_run((folder / "other.h5").string());
  EXPECT_TRUE(other.trajectory.multipliers.empty());
  EXPECT_EQ(other.trajectory.constraint_drift, -1);
}

TEST(RunFile, IsRefusedWithMultipliersThatAreNotThoseOfItsSupports) {
  const TemporaryFolder folder;
  const auto refusal = [&](const plumb::Run& run) -> std::string {
    write_text(folder / "run.h5", encode_run(run));
    try {
      read_run((folder / "run.h5").string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  plumb::Run wrong = run_with_joint();
  for (Eigen::VectorXd& lambda : wrong.trajectory.multipliers) lambda = Eigen::Vector2d(1, 2);
  EXPECT_NE(refusal(wrong).find("multipliers are not those of its supports"), std::string::npos)
      << refusal(wrong);
  wrong = run_with_joint();
  wrong.trajectory.multipliers[1][2] = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(wrong).find("multipliers are not finite"), std::string::npos) << refusal(wrong);
}

/// Calls `visit` with the path and identifier of every data set of a file.
template <class Visit>
void for_each_data_set(const fs::path& path, Visit visit) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5Ovisit(
      file, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t root, const char* name, const H5O_info_t* info, void* data) -> herr_t {
        if (info->type != H5O_TYPE_DATASET) return 0;
        const hid_t set = H5Dopen2(root, name, H5P_DEFAULT);
        (*static_cast<Visit*>(data))(std::string(name), set);
        H5Dclose(set);
        return 0;
      },
      &visit);
  H5Fclose(file);
}

TEST(RunFile, HasAUnitOnEveryDataSet) {
  const TemporaryFolder folder;
  write_text(folder / "run.h5", encode_run(run_with_joint()));
  int sets = 0;
  for_each_data_set(folder / "run.h5", [&](const std::string& name, hid_t set) {
    ++sets;
    EXPECT_GT(H5Aexists(set, "unit"), 0) << name;
  });
  EXPECT_GT(sets, 25);
}

}  // namespace run_file_test
}  // namespace plumb
