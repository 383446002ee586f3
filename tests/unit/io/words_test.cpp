#include "common/io/words.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "common/io/files.h"

namespace accord {
namespace {

TEST(InQuotes, EscapesWhatWouldBreakALine) {
  EXPECT_EQ(in_quotes("a\nb"), "\"a\\x0Ab\"");
  EXPECT_EQ(in_quotes("\x1B[31m"), "\"\\x1B[31m\"");
  EXPECT_EQ(in_quotes("\xFF"), "\"\\xFF\"");
  EXPECT_EQ(in_quotes("Gerät"), "\"Gerät\"");
  EXPECT_EQ(in_quotes("\xC2\x9B[31m \xC2\xA0"), "\"\\xC2\\x9B[31m \xC2\xA0\"") << "U+009B is ESC [";
}

TEST(InQuotes, CutsLongTextBetweenCharacters) {
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "ü";
  const std::string quoted_text = in_quotes(umlauts);
  EXPECT_LT(quoted_text.size(), 70U);
  EXPECT_TRUE(quoted_text.ends_with("...\""));
  EXPECT_EQ(first_unprintable(quoted_text), std::string::npos);
}

TEST(InQuotes, LeavesPathsWhole) {
  const std::string path = "/home/" + std::string(200, 'x') + "/rack.stl";
  EXPECT_EQ(path_in_quotes(path), "\"" + path + "\"");
}

TEST(LineAt, CountsFromOne) {
  EXPECT_EQ(line_at("a\nb\n", 0), 1);
  EXPECT_EQ(line_at("a\nb\n", 1), 1);
  EXPECT_EQ(line_at("a\nb\n", 2), 2);
}

TEST(NearestWord, FindsTypingErrorsOnly) {
  constexpr std::array<std::string_view, 4> kWords = {"name", "model", "start", "goal"};
  EXPECT_EQ(nearest_word("strat", kWords), "start");
  EXPECT_EQ(nearest_word("gaol", kWords), "goal");
  EXPECT_EQ(nearest_word("models", kWords), "model");
  EXPECT_EQ(nearest_word("colour", kWords), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(1000, 'x'), kWords), std::nullopt);
}

TEST(FirstUnprintable, KnowsUtf8) {
  EXPECT_EQ(first_unprintable("tab\t line\r\n ü € 𝄞"), std::string::npos);
  EXPECT_EQ(first_unprintable(std::string_view("a\0b", 3)), 1U);
  EXPECT_EQ(first_unprintable("ab\xC0\x80"), 2U);        // overlong
  EXPECT_EQ(first_unprintable("\xED\xA0\x80"), 0U);      // surrogate
  EXPECT_EQ(first_unprintable("\xF5\x80\x80\x80"), 0U);  // beyond Unicode
  EXPECT_EQ(first_unprintable("abc\xE2\x82"), 3U);       // cut off
}

}  // namespace
}  // namespace accord
