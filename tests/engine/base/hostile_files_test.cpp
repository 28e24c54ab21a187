#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/confined_process.h"
#include "engine/base/hdf5.h"
#include "tests/engine/given_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace hostile_files_test {

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int k = 0; k < count; ++k) result += text;
  return result;
}

TEST(HostileFiles, TomlOfAnyDepthIsRefusedInOneLine) {
  constexpr int deep = 30'000;
  const std::string dots = repeated("b.", deep), high = "is more than 100 tables or lists deep";
  const std::vector<std::pair<std::string, std::string>> texts{
      {"q = {a=\"\\\"#\", " + dots + "c = 1}", high},
      {dots + "c = 1", high},
      {dots + "c = 1 1", "not valid TOML"},
      {"[" + dots + "c]\nx = 1", high},
      {"[[" + dots + "c]]", high},
      {repeated("\"a#\".", deep) + "c = 1", high},
      {repeated("'\"'.", deep) + "c = 1", high},
      {"x = \"\"\"\n#\\\"\"\"\"\n" + dots + "c = 1", high},
      {"a = 1\r\n" + dots + "c = 1", high},
      {"\xEF\xBB\xBF" + dots + "c = 1", high},
      {"x = [{" + dots + "c = [{" + dots + "d = 1}]}]", high},
      {"x = " + std::string(deep, '['), "not valid TOML"},
      {"x = " + repeated("{a = ", deep), "not valid TOML"},
      {std::string("a = 1\0\n", 7), "not valid TOML"},
      {"a = \"\xff\"", "not valid TOML"},
  };
  for (const auto& [text, expected] : texts) {
    CaseSource source = small_case();
    source.file.text = text;
    const std::string message = refusal(source);
    EXPECT_NE(message.find(expected), std::string::npos) << text.substr(0, 40) << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(HostileFiles, AFileThatIsNoTomlIsNotShown) {
  CaseSource source = small_case();
  source.file.text = "secret:x:0:0:word:/root:/bin/sh\n";
  const std::string message = refusal(source);
  EXPECT_EQ(message.find("secret"), std::string::npos) << message;
  EXPECT_EQ(message.find("word"), std::string::npos) << message;
}

TEST(HostileFiles, AFileThatIsNoTableIsNotShown) {
  const std::string message = refusal(given_case("secret:x:0\nword:y:1\n"));
  EXPECT_NE(message.find("the file has one column only"), std::string::npos) << message;
  EXPECT_EQ(message.find("secret"), std::string::npos) << message;
}

TEST(HostileFiles, ATableOfVeryManyColumnsIsReadInTheTimeOfItsLength) {
  constexpr int columns = 30'000;
  std::string file = "t,tip.y";
  for (int k = 0; k < columns; ++k) file += ",c" + std::to_string(k);
  for (const char* row : {"\n0,0", "\n1,-1"}) file += row + repeated(",0", columns);
  const std::clock_t started = std::clock();
  EXPECT_EQ(refusal(given_case(file)), "accepted");
  const double taken = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
  // Comparing all names with all took half a second on an idle machine; this takes some hundredths.
  EXPECT_LT(taken, 5) << "s of the processor";
}

TEST(HostileFiles, ListsOfValuesAndOfTablesAreBounded) {
  CaseSource source = small_case();
  source.file.text += repeated("[[run]]\n", 101);
  EXPECT_NE(refusal(source).find("at most 100 tables [[run]] are allowed, found 101"), std::string::npos)
      << refusal(source);
}

std::string answer_of(ConfinedProcess::Answer answer) {
  try {
    ConfinedProcess process({64 << 20, 1, 1 << 20}, std::move(answer));
    return process.ask("?");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(ConfinedProcess, AnswersAndCanDoNothingElse) {
  EXPECT_EQ(answer_of([](const std::string& question) { return question + "!"; }), "?!");
  EXPECT_EQ(answer_of([](const std::string&) -> std::string { throw std::runtime_error("it is wrong"); }),
            "it is wrong");
  const auto able = [](int result) { return std::string(result >= 0 ? "could" : "could not"); };
  EXPECT_EQ(answer_of([&](const std::string&) { return able(::open("/etc/passwd", O_RDONLY)); }),
            "could not");
  EXPECT_EQ(answer_of([&](const std::string&) { return able(::dup(0)); }), "could not");
}

TEST(ConfinedProcess, EndsAloneWhereItCrashesRunsOnOrWantsTooMuch) {
  EXPECT_EQ(answer_of([](const std::string&) -> std::string { ::_exit(3); }),
            "it is damaged or hostile (reading it ended early)");
  EXPECT_EQ(answer_of([](const std::string&) -> std::string {
              std::raise(SIGSEGV);
              volatile int* nowhere = nullptr;
              return std::to_string(*nowhere);
            }),
            "it is damaged or hostile (reading it ended by SIGSEGV)");
  EXPECT_EQ(answer_of([](const std::string&) { return std::string(2 << 20, 'x'); }),
            "it is damaged or hostile (what is in it is longer than it can be)");
  const std::string endless = answer_of([](const std::string&) -> std::string {
    volatile bool goes_on = true;
    while (goes_on) {
    }
    return "";
  });
  EXPECT_TRUE(endless.starts_with("it is damaged or hostile (reading it ")) << endless;
}

TEST(HostileFiles, ChangedHdf5IsReadOrRefused) {
  hdf5::Writer writer;
  const std::vector<double> times{0, 1, 2}, heights{0, -1, -4};
  writer.numbers("time", {3}, times.data(), "s");
  writer.numbers("probes/tip.y", {3}, heights.data(), "m");
  const std::string good = writer.bytes();
  std::mt19937 random(1);
  for (int k = 0; k < 100; ++k) {
    std::string bytes = good;
    for (int change = 0; change < 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
    const std::string message = refusal(given_case(bytes));
    EXPECT_TRUE(message == "accepted" || message.find("chrono.csv") != std::string::npos) << message;
  }
}

}  // namespace hostile_files_test
}  // namespace plumb
