#include "tests/engine/small_case.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "engine/base/errors.h"

namespace plumb {

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

CaseSource small_case() {
  const std::string folder = PLUMB_TEST_DATA "/";
  return {{"case.toml", text_of_file(folder + "small_case.toml")},
          {},
          {{"small_reference.toml", text_of_file(folder + "small_reference.toml")}}};
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string refusal(const CaseSource& source) {
  try {
    load_case(source);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  } catch (const UsageError& error) {
    return std::string("usage: ") + error.what();
  }
}

bool matches(const std::string& message, const std::string& expected) {
  constexpr std::string_view anything = "…";
  std::string_view rest = message, parts = expected;
  for (bool first = true;; first = false) {
    const std::size_t to = parts.find(anything);
    const std::string_view part = parts.substr(0, to);
    if (to == parts.npos) return first ? rest == part : rest.ends_with(part);
    const std::size_t found = rest.find(part);
    if (found == rest.npos || (first && found != 0)) return false;
    rest.remove_prefix(found + part.size());
    parts.remove_prefix(to + anything.size());
  }
}

TEST(SmallCase, IsAccepted) {
  EXPECT_EQ(refusal(small_case()), "accepted");
}

}  // namespace plumb
