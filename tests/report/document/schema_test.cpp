#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "engine/base/document_sum.h"
#include "report/document/document.h"
#include "report/index/run_index.h"
#include "report/program/results_schema.h"
#include "report/study/economy/economy_results.h"
#include "report/study/sensitivity/sensitivity_results.h"
#include "report/study/stability/stability_results.h"
#include "report/study/sweep/sweep_results.h"
#include "report/study/variants/variants_results.h"
#include "report/study/work_precision/work_precision_results.h"
#include "report/verdict/results.h"
#include "tests/report/program/program.h"
#include "tests/report/study/made_studies.h"
#include "tests/report/study/stability/made_stability.h"
#include "tests/report/study/work_precision/made_study.h"

namespace plumb {
namespace schema_test {

using Json = nlohmann::ordered_json;

const std::string source = PLUMB_SOURCE_DIR;

/// Holds files against the schema of results.json by a validator of another language.
Ended check(const fs::path& folder, const std::vector<std::string>& files) {
  static const TemporaryFolder schema;
  static const std::string path = (schema / "results.schema.json").string();
  if (!fs::exists(path)) write_text(path, results_schema());
  std::vector<std::string> command{"/usr/bin/python3", source + "/tests/check_schema.py", path};
  command.insert(command.end(), files.begin(), files.end());
  return run_command(command, folder);
}

/// The results.json of a study, as it is read from its file.
template <class Kind>
Json results_of(const Kind& study, StudyReport (*evaluate)(const Kind&, const Stages&)) {
  Stages stages;
  stages.add("solving", 0.5);
  return Json::parse(to_json(content_of(evaluate(study, stages)).document, false));
}

StabilityStudyFile whole_stability() {
  StabilityStudyFile file = made_stability_file();
  file.result.maps.front().method = file.loaded.spec.method;
  file.result.maps.front().method.parameters["order"] = 2;
  file.result.maps.front().limits.front() = {-1, std::numeric_limits<double>::infinity()};
  file.result.statistics.push_back(
      {"reference", 5, 0, Outcome::completed, "", 10, true, -0.5, 0.1, 2, std::nan("")});
  return file;
}

Study whole_work_precision() {
  Study study = made_study_of_a_case();
  study.result.common_floors = {{1e-9, {0, 1, 2}}};
  study.result.runs.front().method.parameters["rho"] = 0.5;
  study.result.given_curves = {made_given_curve("laptop", 0.1)};
  study.result.runs.front().time_error.tip_max = std::nan("");
  return study;
}

/// Documents of every kind by its name, with something in every list.
std::map<std::string, Json> made_documents() {
  std::map<std::string, Json> all;
  all["stability"] = results_of(whole_stability(), evaluate_stability);
  all["sweep"] = results_of(made_sweep(), evaluate_sweep);
  all["variants"] = results_of(made_variants(), evaluate_variants);
  all["economy"] = results_of(made_economy_study(), evaluate_economy);
  all["sensitivity"] = results_of(made_sensitivity(), evaluate_sensitivity);
  all["work_precision"] = results_of(whole_work_precision(), evaluate_study);
  Stages stages;
  stages.add("solving", 0.5);
  all["run"] = Json::parse(to_json(document_of(evaluate(run_with("made"), stages), {})));
  History history{{history_entry(all["run"]), entry_without_report("gone", {}, "crashed")}, {}};
  all["run"][history_key] = {{"file", "h.jsonl"}, {"runs", history.entries}};
  Picture picture;
  picture.file = "figures/shared_tip.x.png";
  all["index"] =
      Json::parse(to_json(index_of({indexed("made", all["run"]), {"gone"}}, {picture}, 2, history)));
  return all;
}

/// A document with one of each list of objects, which says as much of the schema.
Json shortened(Json json) {
  if (json.is_array() && json.size() > 1 && json.front().is_object()) json = Json::array({json.front()});
  if (json.is_structured())
    for (Json& inner : json) inner = shortened(inner);
  return json;
}

/// Shows every value of a document with its place, "sweep.runs.0.method", the inner ones first.
template <class Visit>
void walk(Json& json, const std::string& place, const Visit& visit) {
  const std::string before = place.empty() ? "" : place + ".";
  if (json.is_object())
    for (auto& [key, value] : json.items()) walk(value, before + key, visit);
  if (json.is_array())
    for (std::size_t k = 0; k < json.size(); ++k) walk(json[k], before + std::to_string(k), visit);
  visit(json, place);
}

constexpr const char* surprise = "surprise";

/// Faulty documents, and what is to be said of each place of them.
class Faults {
 public:
  using Said = std::vector<std::pair<std::string, std::string>>;

  void add(const Json& json, const Said& places) {
    files_.push_back(std::to_string(files_.size()) + ".json");
    write_text(folder_ / files_.back(), json.dump());
    for (const auto& [place, text] : places) expected_.push_back({files_.back(), place, text});
  }

  void expect_said() const {
    const Ended ended = check(folder_.path(), files_);
    EXPECT_EQ(ended.status, 1) << ended.err;
    std::map<std::pair<std::string, std::string>, std::string> said;
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t file = line.find(": "), place = line.find(": ", file + 2);
      said[{line.substr(0, file), line.substr(file + 2, place - file - 2)}] += line.substr(place + 2) + "\n";
    }
    for (const auto& [file, place, text] : expected_) {
      const auto found = said.find({file, place});
      EXPECT_TRUE(found != said.end() && found->second.find(text) != std::string::npos)
          << file << " is to be refused at '" << place << "' by " << text << ", but is "
          << (found == said.end() ? "not" : found->second);
    }
  }

  std::size_t count() const { return expected_.size(); }

 private:
  struct Expected {
    std::string file, place, text;
  };
  TemporaryFolder folder_;
  std::vector<std::string> files_;
  std::vector<Expected> expected_;
};

/// Objects whose keys are names of the case's or of the program's own.
bool is_table_of_names(const std::string& place) {
  static const std::regex tables(
      R"(((case|economy.*|work_precision.*)\.)?method|variants\.0\.method|case\.parameters|.*method\.parameters|)"
      R"((work_precision\.)?provenance|seconds|probes|sweep\.(outcomes|methods(\.\w+)?))");
  return std::regex_match(place, tables);
}

bool may_be_missing(const std::string& place, const std::string& key) {
  static const std::set<std::string> optional{"step",        "rtol",    "atol",    "from", "mesh",
                                              check_sum_key, "at_once", "history", "fault"};
  if (place.empty() && key == "kind") return true;  // without it an index is a study of none
  if (key == "coverage" || (place == "case" && key == "method")) return true;
  return (optional.contains(key) && !place.starts_with("stability.energies")) ||
         (is_table_of_names(place) && key != "name" && key != "t");
}

TEST(Schema, HoldsForEveryKindOfStudyAndForAnIndex) {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (const auto& [name, document] : made_documents()) {
    Json json = shortened(document);
    walk(json, "", [&, kind = name](Json& value, const std::string& place) {
      if (!place.starts_with(kind) || place.ends_with("overrides") || !value.is_array()) return;
      EXPECT_FALSE(value.empty()) << place << ": of its items nothing is seen";
    });
    files.push_back(name + ".json");
    write_text(folder / files.back(), document.dump());
  }
  const Ended ended = check(folder.path(), files);
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
}

TEST(Schema, RefusesAKeyThatIsNotDescribedInEveryObject) {
  Faults faults;
  for (const auto& [name, document] : made_documents()) {
    Json json = shortened(document);
    Faults::Said said;
    walk(json, "", [&](Json& object, const std::string& place) {
      if (!object.is_object()) return;
      object[surprise] = true;
      // Where any name may stand, not any value may.
      if (is_table_of_names(place))
        said.emplace_back(place + "." + surprise, "True is not of type");
      else
        said.emplace_back(place, "'surprise'");
    });
    faults.add(json, said);
  }
  EXPECT_GT(faults.count(), 100U);
  faults.expect_said();
}

TEST(Schema, RefusesAValueOfAnotherTypeInEveryPlace) {
  Faults faults;
  for (const auto& [name, document] : made_documents()) {
    Json json = shortened(document);
    Faults::Said said;
    walk(json, "", [&](Json& value, const std::string& place) {
      if (value.is_structured()) return;
      value = Json::object();
      said.emplace_back(place, "");
    });
    faults.add(json, said);
  }
  EXPECT_GT(faults.count(), 500U);
  faults.expect_said();
}

TEST(Schema, RefusesAnObjectOfWhichAKeyIsMissing) {
  Faults faults;
  const auto lack = [](const std::string& key) { return "'" + key + "' is a required property"; };
  for (const auto& [name, document] : made_documents()) {
    const Json whole = shortened(document);
    // All keys of what has no keys itself at once; those of objects and lists one by one.
    Json without = whole;
    Faults::Said said;
    std::vector<std::pair<std::string, std::string>> inner;
    walk(without, "", [&](Json& object, const std::string& place) {
      if (!object.is_object()) return;
      const Json before = object;
      for (const auto& [key, value] : before.items()) {
        if (may_be_missing(place, key)) continue;
        if (value.is_structured()) {
          inner.emplace_back(place, key);
        } else {
          object.erase(key);
          said.emplace_back(place, lack(key));
        }
      }
    });
    faults.add(without, said);
    for (const auto& [place, key] : inner) {
      Json json = whole;
      walk(json, "", [&, in = place, of = key](Json& object, const std::string& at) {
        if (at == in) object.erase(of);
      });
      faults.add(json, {{place, lack(key)}});
    }
  }
  EXPECT_GT(faults.count(), 500U);
  faults.expect_said();
}

TEST(Schema, RefusesAWordThatIsNone) {
  const std::map<std::string, Json> all = made_documents();
  Faults faults;
  const auto faulty = [&](const std::string& name, const std::string& place, const Json& value = "opinion") {
    Json json = all.at(name);
    std::string pointer = "/" + place;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    json.at(Json::json_pointer(pointer)) = value;
    faults.add(json, {{place, ""}});
  };
  for (const char* place :
       {"verdicts.0.status", "stability.maps.0.axis", "stability.maps.0.limit_kind", "stability.tolerance",
        "stability.maps.0.points.3.outcome", "stability.critical_steps.0.beyond",
        "stability.energies.0.outcome", "stability.statistics.0.outcome"})
    faulty("stability", place);
  faulty("sweep", "sweep.runs.1.outcome");
  faulty("sweep", "sweep.outcomes.accurate.share", 1.5);
  for (const char* place : {"variants.0.expected_outcome", "variants.0.solve.outcome"})
    faulty("variants", place);
  for (const char* place : {"economy.pictures.0.unit", "economy.pictures.0.tried.0.outcome"})
    faulty("economy", place);
  for (const char* place : {"work_precision.runs.0.outcome", "work_precision.curves.0.family"})
    faulty("work_precision", place);
  for (const char* place : {"kind", "reports.0.outcome", "reports.1.verdicts.0.kind"}) faulty("index", place);
  for (const char* place : {"verdicts.0.kind", "outcome", "solve.outcome", "references.0.kind"})
    faulty("run", place);
  for (const auto& [name, json] : all) faulty(name, "schema_version", results_version + 1);
  faults.expect_said();
}

TEST(Schema, RefusesAStudyOfTwoKinds) {
  const std::map<std::string, Json> all = made_documents();
  Faults faults;
  Json both = all.at("sweep");
  both["economy"] = all.at("economy").at("economy");
  faults.add(both, {{"", "is valid under each of"}});
  Json index = all.at("index");
  index["sweep"] = both["sweep"];
  faults.add(index, {{"", "'sweep' was unexpected"}});
  faults.expect_said();
}

TEST(Schema, HoldsForEveryKindOfRun) {
  const TemporaryFolder folder;
  const std::string small = source + "/tests/data/small_case.toml";
  const auto run = [&](const std::string& name, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "run");
    arguments.insert(arguments.end(),
                     {"-o", name, "--set", "scene.frame_rate=1", "--set", "scene.size=[64,48]"});
    const Ended ended = plumb_in(folder.path(), arguments);
    EXPECT_TRUE(fs::exists(folder / name / "results.json")) << ended.err;
  };
  run("plain", {small});
  run("plain", {small, "--baseline", "plain"});  // with what changed since the last run, too
  run("failed", {small, "--set", "method.name=rk4", "--set", "method.step=0.02"});
  run("pendulum",
      {case_path("pendulum.toml"), "--set", "time.end=0.1", "--set", "reference.0.coverage.to=0.1", "--set",
       "reference.1.coverage.to=0.1", "--set", "study.work_precision.quick.points=3"});
  run("economy", {small, "--economy"});
  run("given", {case_path("bring_your_own.toml")});
  run("beside", {case_path("bring_your_own.toml"), "--set", "method.name=rk4", "--set", "method.step=1e-3",
                 "--set", "cable.elements=4", "--set", "time.output_interval=0.02"});
  const Ended ended =
      check(folder.path(), {"economy/results.json", "given/results.json", "beside/results.json",
                            "plain/results.json", "failed/results.json", "pendulum/results.json"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
}

}  // namespace schema_test
}  // namespace plumb
