#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/integrate/method_info.h"
#include "render/gl/environment.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace readme_test {

TEST(Readme, TableOfMethodsSaysWhatTheProgramSays) {
  const std::string readme = read_text(fs::path(PLUMB_SOURCE_DIR) / "README.md");
  for (const MethodInfo& method : method_infos()) {
    const std::string start = fmt::format("| `{}` | {} | {}", method.name, method.order, word(method.family));
    const std::string end = fmt::format("| {} | {} |\n", method.conserves, method.use);
    const std::size_t at = readme.find(start);
    ASSERT_NE(at, readme.npos) << start;
    EXPECT_NE(readme.substr(at, readme.find('\n', at) - at + 1).find(end), readme.npos)
        << method.name << " should end with " << end;
  }
}

TEST(Readme, NamesEveryVerbOfTheProgram) {
  const std::string readme = read_text(fs::path(PLUMB_SOURCE_DIR) / "README.md");
  for (const char* verb : {"run", "solve", "render", "report", "study", "check", "diff", "export", "doctor"})
    EXPECT_NE(readme.find(fmt::format("| `plumb {}", verb)), readme.npos) << verb;
}

TEST(Readme, NamesEveryVariableOfTheEnvironment) {
  const std::string readme = read_text(fs::path(PLUMB_SOURCE_DIR) / "README.md");
  for (const EnvironmentVariable& variable : environment_variables())
    EXPECT_NE(readme.find(fmt::format("\n| `{}` | {}", variable.name, variable.meaning)), readme.npos)
        << variable.name << " | " << variable.meaning;
}

}  // namespace readme_test
}  // namespace plumb
