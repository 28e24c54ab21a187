#include <nlohmann/json.hpp>

#include "report/verdict/results.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace schema_test {

using Json = nlohmann::ordered_json;

const std::string source = PLUMB_SOURCE_DIR;

/// Holds files against the schema of results.json by a validator of another language.
Ended check(const fs::path& folder, const std::vector<std::string>& files) {
  std::vector<std::string> command{"/usr/bin/python3", source + "/tests/check_schema.py",
                                   source + "/report/results.schema.json"};
  command.insert(command.end(), files.begin(), files.end());
  return run_command(command, folder);
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

TEST(Schema, RefusesWhatIsNoReport) {
  const TemporaryFolder folder;
  plumb_in(folder.path(), {"run", source + "/tests/data/small_case.toml", "-o", "run", "--set",
                           "scene.frame_rate=1", "--set", "scene.size=[64,48]"});
  const Json good = Json::parse(read_text(folder / "run/results.json"));
  std::vector<std::string> files;
  const auto faulty = [&](const char* what, auto change) {
    Json json = good;
    change(json);
    files.push_back(what + std::string(".json"));
    write_text(folder / files.back(), json.dump());
  };
  faulty("another version", [](Json& json) { json["schema_version"] = results_version + 1; });
  faulty("a key that is missing", [](Json& json) { json.erase("energy"); });
  faulty("a key that is not described", [](Json& json) { json["surprise"] = 1; });
  faulty("a fifth kind of verdict", [](Json& json) { json["verdicts"][0]["kind"] = "opinion"; });
  faulty("a text for a number", [](Json& json) { json["solve"]["steps"] = "many"; });
  const Ended ended = check(folder.path(), files);
  EXPECT_EQ(ended.status, 1);
  for (const std::string& file : files)
    EXPECT_NE(ended.out.find(file + ": "), std::string::npos)
        << file << " is taken for a report: " << ended.out;
}

}  // namespace schema_test
}  // namespace plumb
