#include "client/terminal_text.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

TEST(TerminalText, LeavesNothingThatATerminalWouldObey) {
  EXPECT_EQ(terminal_text("box-1", 20), "box-1");
  EXPECT_EQ(terminal_text("\x1B[2J\r\n\x7F", 40), "\\x1B[2J\\x0D\\x0A\\x7F");
  EXPECT_EQ(terminal_text("\xC2\x9B", 40), "\\xC2\\x9B") << "CSI as one character";
  EXPECT_EQ(terminal_text("\xE2\x80\xAE", 40), "\\xE2\\x80\\xAE") << "writes to the left";
}

TEST(TerminalText, IsCutBetweenCharactersAndNeverLongerThanAsked) {
  EXPECT_EQ(terminal_text("abcdefgh", 8), "abcdefgh");
  EXPECT_EQ(terminal_text("abcdefghi", 8), "abcde...");
  EXPECT_EQ(terminal_text("abc\x1B defg", 8), "abc...") << "no half of an escape";
  EXPECT_EQ(terminal_text("abcd", 3), "...");
}

}  // namespace
}  // namespace accord
