#include "render/gl/markup.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "render/gl/text.h"

namespace plumb {
namespace markup_test {

using Runs = std::vector<TextRun>;

TEST(Markup, BracesEncloseSuperscriptsAndSubscripts) {
  EXPECT_EQ(read_markup("10^{3} h_{max}!"), (Runs{{"10", Script::none},
                                                  {"3", Script::above},
                                                  {" h", Script::none},
                                                  {"max", Script::below},
                                                  {"!", Script::none}}));
}

TEST(Markup, OneCharacterBeyondAsciiNeedsNoBraces) {
  EXPECT_EQ(read_markup("ρ_∞=1"), (Runs{{"ρ", Script::none}, {"∞", Script::below}, {"=1", Script::none}}));
}

TEST(Markup, AHyphenBeforeADigitOfAScriptIsAMinusSign) {
  EXPECT_EQ(read_markup("m s^{-2}"), (Runs{{"m s", Script::none}, {"−2", Script::above}}));
  EXPECT_EQ(read_markup("a_{x-y}-3"),
            (Runs{{"a", Script::none}, {"x-y", Script::below}, {"-3", Script::none}}));
}

TEST(Markup, WhatIsNotValidIsShownAsItStands) {
  for (const char* text : {"mid_y", "a^b", "a^{b", "x_{}", "^", "_", "}{", "\\", "a\\b", "f_{g{h}}"})
    EXPECT_EQ(read_markup(text), (Runs{{text, Script::none}})) << text;
  EXPECT_TRUE(read_markup("").empty());
}

TEST(Markup, ABackslashTakesAwayTheMeaning) {
  EXPECT_EQ(read_markup(R"(10\^{3} \\ h\_∞)"), (Runs{{R"(10^{3} \ h_∞)", Script::none}}));
}

TEST(Literal, ShowsEveryTextJustAsItIs) {
  EXPECT_TRUE(rc::check([] {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
        "^", "_", "{", "}", "\\", "^{", "_{", "a", "∞", "-1", "ρ", "\xff", "<b>"));
    std::string text;
    for (const std::string& piece : pieces) text += piece;
    const Runs runs = read_markup(literal(text));
    if (text.empty())
      RC_ASSERT(runs.empty());
    else
      RC_ASSERT(runs == (Runs{{text, Script::none}}));
  }));
}

TEST(Markup, NeverLosesACharacterOfWhatIsNotMarkup) {
  EXPECT_TRUE(rc::check([](const std::string& text) {
    std::size_t kept = 0;
    for (const TextRun& run : read_markup(text)) kept += run.text.size();
    // A script drops a sign and two braces, an escape its backslash; a minus sign is two bytes longer.
    RC_ASSERT(kept <= 3 * text.size());
    if (text.find_first_of("^_\\") == text.npos) RC_ASSERT(kept == text.size());
  }));
}

TEST(Markup, HasNoWidthOfItsOwnInAText) {
  const Font font;
  EXPECT_DOUBLE_EQ(font.measure(literal("a^{2}_∞\\"), {20}).width,
                   font.measure("a\\^\\{2\\}\\_∞\\\\", {20}).width);
  EXPECT_GT(font.measure(literal("a^{2}"), {20}).width, font.measure("a^{2}", {20}).width);
}

}  // namespace markup_test
}  // namespace plumb
