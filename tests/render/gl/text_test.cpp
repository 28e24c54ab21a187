#include "render/gl/text.h"

#include <gtest/gtest.h>

#include <numeric>

#include "render/gl/utf8.h"

namespace plumb {
namespace text_test {

long ink(const TextBitmap& bitmap) {
  return std::accumulate(bitmap.coverage.begin(), bitmap.coverage.end(), 0L);
}

// Rows from the top to the first with ink.
int first_row(const TextBitmap& bitmap) {
  for (std::size_t i = 0; i < bitmap.coverage.size(); ++i)
    if (bitmap.coverage[i] > 0) return static_cast<int>(i) / bitmap.width;
  return bitmap.height;
}

TEST(Text, WidthGrowsInProportionToTheSize) {
  const Font font;
  const double at_20 = font.measure("time [s]", {20}).width;
  EXPECT_NEAR(font.measure("time [s]", {60}).width, 3 * at_20, 1e-9);
}

TEST(Text, BoldIsWiderAndDarker) {
  const Font font;
  EXPECT_GT(font.measure("Energies", {30, Weight::bold}).width, font.measure("Energies", {30}).width);
  EXPECT_GT(ink(font.draw("Energies", {30, Weight::bold})), ink(font.draw("Energies", {30})));
}

TEST(Text, SuperscriptIsNarrowerAndStandsHigher) {
  const Font font;
  EXPECT_LT(font.measure("10^{5}", {40}).width, font.measure("105", {40}).width);
  EXPECT_LT(first_row(font.draw("10^{5}", {40})), first_row(font.draw("105", {40})));
}

// Rows from the top to the last with ink.
int last_row(const TextBitmap& bitmap) {
  for (std::size_t i = bitmap.coverage.size(); i-- > 0;)
    if (bitmap.coverage[i] > 0) return static_cast<int>(i) / bitmap.width;
  return -1;
}

TEST(Text, SubscriptIsNarrowerAndReachesLower) {
  const Font font;
  EXPECT_LT(font.measure("h_{5}", {40}).width, font.measure("h5", {40}).width);
  EXPECT_GT(last_row(font.draw("h_{5}", {40})), last_row(font.draw("h5", {40})));
  EXPECT_DOUBLE_EQ(font.measure("h_{5}", {40}).width, font.measure("h^{5}", {40}).width);
  EXPECT_DOUBLE_EQ(font.measure("h_{5}+h^{2}", {40}).width,
                   font.measure("h_{5}", {40}).width + font.measure("+h^{2}", {40}).width);
}

TEST(Text, UnclosedSuperscriptIsDrawnAsItStands) {
  const Font font;
  EXPECT_DOUBLE_EQ(font.measure("a^{b", {20}).width,
                   font.measure("a^", {20}).width + font.measure("{b", {20}).width);
}

TEST(Text, GreekAndSignsHaveGlyphsOfTheirOwn) {
  const Font font;
  const TextBitmap missing = font.draw("\U0010FFFF", {40});
  for (const char* text : {"\u03c9", "\u00b2", "\u2212", "\u00d7", "\u00b7"})
    EXPECT_NE(font.draw(text, {40}).coverage, missing.coverage) << text;
}

TEST(Text, TurnedFourTimesIsTheSame) {
  const TextBitmap bitmap = Font().draw("gj^{2}", {24});
  TextBitmap t = turned(turned(turned(turned(bitmap))));
  EXPECT_EQ(t.coverage, bitmap.coverage);
  EXPECT_EQ(t.left, bitmap.left);
  EXPECT_EQ(t.base, bitmap.base);
}

TEST(Utf8, DecodesCharactersOfEveryLength) {
  EXPECT_EQ(decode_utf8("a\u00e9\u2212\U0001F600"), U"a\u00e9\u2212\U0001F600");
}

TEST(Utf8, EachInvalidByteBecomesOneReplacement) {
  EXPECT_EQ(decode_utf8("a\xff"
                        "b"),
            U"a\uFFFD"
            U"b");
  EXPECT_EQ(decode_utf8("\xe2\x88"), U"\uFFFD\uFFFD") << "cut short";
  EXPECT_EQ(decode_utf8("\xc0\x80"), U"\uFFFD\uFFFD") << "longer than needed";
  EXPECT_EQ(decode_utf8("\xed\xa0\x80"), U"\uFFFD\uFFFD\uFFFD") << "half of a surrogate pair";
}

}  // namespace text_test
}  // namespace plumb
