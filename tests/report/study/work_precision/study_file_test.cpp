#include <gtest/gtest.h>
#include <hdf5.h>

#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/study/work_precision/work_precision_file.h"
#include "report/study/work_precision/work_precision_json.h"
#include "tests/engine/study/in_memory.h"
#include "tests/engine/study/work_precision/tiny_study.h"
#include "tests/report/program/program.h"
#include "tests/report/study/work_precision/made_study.h"

namespace plumb {
namespace study_file_test {

/// A study of two methods, with all that one can have.
const Study& tiny_study() {
  static const Study study = [] {
    const LoadedCase loaded = tiny_study_case();
    return Study{loaded, run_work_precision(loaded.spec, false, InMemory())};
  }();
  return study;
}

TEST(WorkPrecisionFile, KeepsEverythingOfAStudy) {
  const TemporaryFolder folder;
  write_text(folder / "study.h5", encode_study(tiny_study()));
  const Study back = read_study((folder / "study.h5").string());
  EXPECT_EQ(work_precision_json(back.result).dump(1), work_precision_json(tiny_study().result).dump(1));
  EXPECT_EQ(back.loaded.spec, tiny_study().loaded.spec);
}

TEST(WorkPrecisionFile, KeepsTheCurvesOfOtherPrograms) {
  const TemporaryFolder folder;
  Study study = tiny_study();
  study.result.given_curves = {made_given_curve("laptop", 0.5)};
  study.result.yardstick = 0.25;
  write_text(folder / "study.h5", encode_study(study));
  const nlohmann::ordered_json back = work_precision_json(read_study((folder / "study.h5").string()).result);
  EXPECT_EQ(back.at("given_curves").dump(1), work_precision_json(study.result).at("given_curves").dump(1));
  EXPECT_EQ(back.at("given_curves")[0].at("points")[1].at("work_seconds"), 0.5);
  const WorkPrecision again = work_precision_from_json(back);
  EXPECT_EQ(work_precision_json(again).dump(1), back.dump(1));
  study.result.given_curves[0].points[0].seconds = -1;
  write_text(folder / "study.h5", encode_study(study));
  EXPECT_THROW(read_study((folder / "study.h5").string()), InputError);
}

TEST(WorkPrecisionFile, HasAUnitOnEveryDataSet) {
  const TemporaryFolder folder;
  write_text(folder / "study.h5", encode_study(tiny_study()));
  const hid_t file = H5Fopen((folder / "study.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  int sets = 0;
  H5Ovisit(
      file, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t root, const char* name, const H5O_info_t* info, void* data) -> herr_t {
        if (info->type != H5O_TYPE_DATASET) return 0;
        const hid_t set = H5Dopen2(root, name, H5P_DEFAULT);
        EXPECT_GT(H5Aexists(set, "unit"), 0) << name;
        H5Dclose(set);
        ++*static_cast<int*>(data);
        return 0;
      },
      &sets);
  H5Fclose(file);
  EXPECT_GT(sets, 50);
}

TEST(WorkPrecisionFile, CutOrChangedAnywhereIsRefused) {
  const TemporaryFolder folder;
  const std::string whole = encode_study(tiny_study());
  const auto refusal_of = [&](const std::string& bytes) {
    write_text(folder / "study.h5", bytes);
    try {
      read_study((folder / "study.h5").string());
      return std::string("accepted");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  for (const double share : {0.0, 0.1, 0.5, 0.9, 0.999}) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    EXPECT_NE(refusal_of(whole.substr(0, kept)).find("it is no study file, or it was cut short"),
              std::string::npos);
    std::string changed = whole;
    changed[kept] = static_cast<char>(changed[kept] ^ 1);
    EXPECT_NE(refusal_of(changed).find("damaged or changed"), std::string::npos) << share;
  }
  EXPECT_EQ(refusal_of(whole), "accepted");
}

TEST(WorkPrecisionFile, WhoseIndicesLeadNowhereIsRefused) {
  const TemporaryFolder folder;
  Study bad = tiny_study();
  bad.result.curves[0].runs.push_back(bad.result.runs.size());
  write_text(folder / "study.h5", encode_study(bad));
  EXPECT_THROW(read_study((folder / "study.h5").string()), InputError);
  bad = tiny_study();
  bad.result.runs[0].elements = 0;
  write_text(folder / "study.h5", encode_study(bad));
  EXPECT_THROW(read_study((folder / "study.h5").string()), InputError);
  bad = tiny_study();
  bad.result.runs[0].time_error.curve = std::numeric_limits<double>::quiet_NaN();
  write_text(folder / "study.h5", encode_study(bad));
  EXPECT_THROW(read_study((folder / "study.h5").string()), InputError);
}

}  // namespace study_file_test
}  // namespace plumb
