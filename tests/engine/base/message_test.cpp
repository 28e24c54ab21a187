#include "engine/base/message.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "engine/base/errors.h"

namespace plumb {
namespace message_test {

TEST(Message, ShowsWhatATerminalWouldNotShowAsEscapes) {
  EXPECT_EQ(one_line("a\nb\tc\r\x1b[31m\x7f"), "a\\nb\\tc\\r\\x1b[31m\\x7f");
  EXPECT_EQ(one_line("a\u202eb\u200b\u2066\ufeff"), "a\\u202eb\\u200b\\u2066\\ufeff");
  EXPECT_EQ(one_line("\u0085\ufffe"), "\\u0085\\ufffe");
  EXPECT_EQ(one_line("\xff\xc3(\xed\xa0\x80\xc0\xaf"), "\\xff\\xc3(\\xed\\xa0\\x80\\xc0\\xaf");
  EXPECT_EQ(one_line("12 µm, L = 1 m², “ü”, 漢"), "12 µm, L = 1 m², “ü”, 漢");
}

TEST(Message, IsShortenedInItsMiddleAndNeverWithinACharacter) {
  for (const std::string& unit :
       {std::string("a"), std::string("ü"), std::string("漢"), std::string("\x01")}) {
    std::string text = "PATH";
    for (int k = 0; k < 5000; ++k) text += unit;
    const std::string shown = one_line(text + "WHY");
    EXPECT_LE(shown.size(), 400U) << shown;
    EXPECT_TRUE(shown.starts_with("PATH") && shown.ends_with("WHY")) << shown;
    EXPECT_EQ(one_line(shown), shown);
    EXPECT_EQ(shown.find("\\xe6"), std::string::npos) << shown;
  }
}

TEST(Message, HasAtMostFortyCharactersOfAValue) {
  EXPECT_EQ(short_value("1.5 mm"), "1.5 mm");
  EXPECT_EQ(short_value(std::string(41, 'x')), std::string(40, 'x') + "…");
  EXPECT_EQ(short_value("\n"), "\\n");
  EXPECT_LE(short_value(std::string(1 << 20, '\x01')).size(), 50U);
}

TEST(Message, HasNoWordsOfALibrary) {
  std::string from_standard;
  try {
    static_cast<void>(std::stoi("x"));
  } catch (const std::exception& error) {
    from_standard = reason(error);
  }
  EXPECT_EQ(from_standard, "something in it is not what it must be");
  EXPECT_EQ(reason(std::bad_alloc()), "there is not enough memory for it");
  EXPECT_EQ(reason(std::system_error(ENOENT, std::generic_category(), "open")), "No such file or directory");
  EXPECT_EQ(reason(InputError("a.toml: wrong")), "a.toml: wrong");
  EXPECT_EQ(reason(std::length_error("basic_string::_M_create")), "something in it is too long");
}

}  // namespace message_test
}  // namespace plumb
