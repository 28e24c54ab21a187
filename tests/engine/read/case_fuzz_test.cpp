#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "engine/base/errors.h"
#include "engine/case/case_source.h"
#include "tests/engine/given_case.h"
#include "tests/engine/small_case.h"

namespace plumb {
namespace case_fuzz_test {

/// Bytes that mean something in TOML or in an expression, so that a change is likely to reach past the
/// parser.
const std::string telling = "[]{}=\".,#'\\\n\t 0159eE+-*/^()_xinfnatrue\xC3\xA9\x01\x7f\xFF";

std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::size_t changes = 1 + below(3);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    const std::size_t length = std::min(1 + below(12), text.size() - at);
    switch (below(5)) {
      case 0:
        text[at] = telling[below(telling.size())];
        break;
      case 1:
        text.insert(at, 1, telling[below(telling.size())]);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

/// Empty where the text is a case, or is refused with an InputError of one line.
std::string complaint(const CaseSource& source) {
  try {
    load_case(source);
    return "";
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.find('\n') == std::string::npos && !message.empty() ? "" : "not one line: " + message;
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
}

/// The pendulum, with its shorter reference in place of the published one, which takes the longest to read.
CaseSource pendulum() {
  const CaseSource source = load_case(PLUMB_SOURCE_DIR "/cases/pendulum.toml").source;
  const std::string shorter = source.references.at(1).text;
  return {source.file,
          {},
          {{"references/pendulum_published.toml", shorter}, {"references/pendulum_converged.toml", shorter}}};
}

TEST(CaseFuzz, AChangedCaseIsReadOrRefusedInOneLine) {
  std::mt19937 random(1);
  const CaseSource good = pendulum();
  ASSERT_EQ(refusal(good), "accepted");
  for (int i = 0; i < 2000; ++i) {
    CaseSource source = good;
    source.file.text = mutated(good.file.text, random);
    ASSERT_EQ(complaint(source), "") << source.file.text;
  }
}

TEST(CaseFuzz, AChangedReferenceIsReadOrRefusedInOneLine) {
  std::mt19937 random(2);
  const CaseSource good = small_case();
  for (int i = 0; i < 2000; ++i) {
    CaseSource source = good;
    source.references[0].text = mutated(good.references[0].text, random);
    ASSERT_EQ(complaint(source), "") << source.references[0].text;
  }
}

TEST(CaseFuzz, AChangedTableOfAGivenRunIsReadOrRefusedInOneLine) {
  std::mt19937 random(4);
  const std::string good = "t;X [mm];tip.y [m]\n0;\"1,5\";0\n0,5;2e0;-0,25\r\n1;3;-1\n";
  ASSERT_EQ(refusal(given_case(good, "columns = { \"tip.x\" = \"X\" }")), "accepted");
  for (int i = 0; i < 2000; ++i) {
    const std::string changed = mutated(good, random);
    ASSERT_EQ(complaint(given_case(changed, "columns = { \"tip.x\" = \"X\" }")), "") << changed;
  }
}

TEST(CaseFuzz, ACaseCutOffAnywhereIsReadOrRefusedInOneLine) {
  const CaseSource good = pendulum();
  for (std::size_t length = 0; length < good.file.text.size(); length += 3) {
    CaseSource source = good;
    source.file.text.resize(length);
    ASSERT_EQ(complaint(source), "") << length;
  }
}

TEST(CaseFuzz, AnOverrideOfAnyBytesIsTakenOrRefusedInOneLine) {
  std::mt19937 random(3);
  const CaseSource good = small_case();
  for (const char* value : {"8", "[0, -9.8, 0]", "8000 / f^2", "{ x = \"y\" }"}) {
    for (int i = 0; i < 300; ++i) {
      const std::string changed = mutated(value, random);
      for (const char* key : {"title", "cable.length", "loads.gravity"}) {
        CaseSource source = good;
        source.overrides = {fmt::format("{}={}", key, changed)};
        ASSERT_EQ(complaint(source), "") << key << "=" << changed;
      }
    }
  }
}

TEST(CaseFuzz, AnOverrideWithAnyKeyIsTakenOrRefusedInOneLine) {
  std::mt19937 random(4);
  const CaseSource good = small_case();
  for (int i = 0; i < 1000; ++i) {
    CaseSource source = good;
    source.overrides = {mutated("probe.0.at=0.5", random)};
    EXPECT_EQ(refusal(source).find('\n'), std::string::npos) << source.overrides[0];
  }
}

TEST(CaseFuzz, DeepNestingIsRefusedAndNotFollowedToTheEndOfTheStack) {
  const auto repeated = [](const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
  };
  const auto deep = [&](const char* form, const std::string& part) {
    return fmt::format(fmt::runtime(form), repeated(part, 100'000));
  };
  for (const std::string& text :
       {deep("a{} = 1", ".a"), deep("[a{}]", ".a"), deep("[a{}]", ".'='"), deep("a = {}", "["),
        deep("a = {}", "{a="), deep("[parameters]\na = \"{}1\"", "("),
        deep("[parameters]\na = \"{}1\"", "1+")}) {
    EXPECT_EQ(complaint({{"deep.toml", text}, {}, {}}), "") << text.substr(0, 40);
    EXPECT_NE(refusal({{"deep.toml", text}, {}, {}}), "accepted");
  }
}

TEST(CaseFuzz, ALongChainOfParametersIsFollowedOrRefused) {
  std::string text = "[parameters]\np0 = 1\n";
  for (int i = 1; i < 900; ++i) text += fmt::format("p{} = \"p{} + 1\"\n", i, i - 1);
  CaseSource source = small_case();
  source.file.text = with(source.file.text, "[parameters]\n", text);
  EXPECT_EQ(load_case(source).spec.parameters.at("p899"), 900);
  for (int i = 900; i < 1100; ++i) text += fmt::format("p{} = 1\n", i);
  source.file.text = with(small_case().file.text, "[parameters]\n", text);
  EXPECT_EQ(refusal(source), "case.toml:2:1: parameters: at most 1000 parameters are allowed");
}

}  // namespace case_fuzz_test
}  // namespace plumb
