// What the formats of maps hold, and what is reported of broken ones.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/io/limits.h"
#include "common/io/movingai_map.h"
#include "common/io/pgm.h"

namespace accord {
namespace {

TEST(MovingAiMap, HasItsLastLineAtTheBottom) {
  Faults faults("m");
  const auto grid =
      parse_movingai_map("type octile\nheight 2\nwidth 3\nmap\n@.G\nT.S\n", "m", faults);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->blocked, (std::vector<std::uint8_t>{1, 0, 1, 1, 0, 0}));
}

TEST(MovingAiMap, ReportsAllBrokenRows) {
  Faults faults("m");
  EXPECT_FALSE(parse_movingai_map("type octile\nheight 3\nwidth 2\nmap\n.\n..\n.x\n", "m", faults));
  const auto list = faults.take();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].line, 5);
  EXPECT_EQ(list[1].line, 7);
}

std::vector<std::string> faults_of_map(std::string_view text) {
  Faults faults("m");
  EXPECT_FALSE(parse_movingai_map(text, "m", faults));
  std::vector<std::string> list;
  for (const Diagnostic& fault : faults.take()) list.push_back(to_string(fault));
  return list;
}

TEST(MovingAiMap, ReportsAllBrokenLinesOfItsHeader) {
  EXPECT_EQ(
      faults_of_map("type hexagonal\nheight high\nwidth 0\nmaps\n"),
      (std::vector<std::string>{"m:1: type: expected \"octile\", not \"hexagonal\"",
                                "m:2: height: expected a number of cells from 1 to 16384, not "
                                "\"high\"",
                                "m:3: width: expected a number of cells from 1 to 16384, not \"0\"",
                                "m:4: map: expected the line \"map\", not \"maps\""}));
}

TEST(MovingAiMap, MissesOneLineOfItsHeaderOnce) {
  EXPECT_EQ(
      faults_of_map("type octile\nwidth 3\nmap\n...\n"),
      (std::vector<std::string>{"m:2: height: expected the line \"height\", not \"width 3\""}));
  EXPECT_EQ(faults_of_map("type octile\nheight 3\n"),
            (std::vector<std::string>{
                "m:2: width: the file ends before the header does; expected the line \"width\""}));
  EXPECT_EQ(faults_of_map(""),
            (std::vector<std::string>{
                "m:1: type: the file ends before the header does; expected the line \"type\""}));
}

TEST(MovingAiMap, ListsBrokenRowsUpToALimit) {
  std::string text = "type octile\nheight 1000\nwidth 2\nmap\n";
  for (std::size_t i = 0; i < 1000; ++i) text += "x\n";
  const auto list = faults_of_map(text);
  ASSERT_EQ(list.size(), limits::kLineFaults + 1);
  EXPECT_EQ(list.back(), "m:24: no more than 20 faults of a file are listed");
}

void nobody(std::string_view text) {
  ADD_FAILURE() << text;
}

TEST(Pgm, TextAndBinarySayTheSame) {
  Faults faults("p");
  const auto text =
      parse_pgm("P2 # c\n3 # width\n2\n255\n0 1 2\n253 254 255\n", "p", nobody, faults);
  const auto binary =
      parse_pgm(std::string("P5\n# c\n3 2\n255\n") + std::string("\0\1\2\xFD\xFE\xFF", 6), "p",
                nobody, faults);
  ASSERT_TRUE(text && binary);
  EXPECT_EQ(text->values, binary->values);
  EXPECT_EQ(text->width, 3U);
}

TEST(Pgm, ReadsTwoBytesAValueAboveMaximum255) {
  Faults faults("p");
  const auto map = parse_pgm(std::string("P5 2 1 1000\n") + std::string("\x03\xE8\0\x07", 4), "p",
                             nobody, faults);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->values, (std::vector<std::uint16_t>{1000, 7}));
}

TEST(Pgm, RefusesWhatIsCutOffWithoutTakingMemoryForIt) {
  Faults faults("p");
  std::vector<std::string> blamed;
  const Blame blame = [&](std::string_view text) { blamed.emplace_back(text); };
  EXPECT_FALSE(parse_pgm("P5 4000 4000 255\n...", "p", blame, faults));
  EXPECT_EQ(blamed, (std::vector<std::string>{"\"p\" ends after 3 of 16000000 cells"}));
  EXPECT_FALSE(parse_pgm("P2 4000 4000 255\n1 2 3", "p", nobody, faults));
  EXPECT_FALSE(parse_pgm("P2 4294967297 1 255\n1", "p", nobody, faults));
  EXPECT_FALSE(parse_pgm("P2 2 1 255\n-1 256", "p", nobody, faults));
  EXPECT_FALSE(parse_pgm("", "p", nobody, faults));
  EXPECT_EQ(faults.count(), 4U);
}

TEST(Pgm, RefusesCellsBrighterThanWhite) {
  Faults faults("p");
  std::vector<std::string> blamed;
  const Blame blame = [&](std::string_view text) { blamed.emplace_back(text); };
  EXPECT_FALSE(parse_pgm("P5 2 1 50\n!~", "p", blame, faults));
  EXPECT_EQ(blamed,
            (std::vector<std::string>{"the cell 1 of \"p\" is 126; expected at most white, 50"}));
}

}  // namespace
}  // namespace accord
