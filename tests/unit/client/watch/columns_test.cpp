#include "client/watch/columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace accord {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Row row(std::string name, std::uint64_t count, std::string why = {}) {
  return {{"name", "name", std::move(name)},
          {"secret", "", std::string("not in tables")},
          {"count", "count", count},
          {"why", "why", std::move(why)}};
}

TEST(Columns, AlignTextsAtTheirBeginAndNumbersAtTheirEnd) {
  EXPECT_THAT(in_columns({row("a", 5, "x"), row("longer", 1234567)}),
              ElementsAre("name      count  why",  //
                          "a             5  x",    //
                          "longer  1234567"));
}

TEST(Columns, AreLeftOutWhereAllIsEmpty) {
  EXPECT_THAT(in_columns({row("a", 5)}), ElementsAre("name  count", "a         5"));
}

TEST(Columns, OfNoRowsAreNothing) {
  EXPECT_THAT(in_columns({}), IsEmpty());
}

TEST(Columns, CutTheLongestTextsWhereThereIsLessRoom) {
  const auto lines = in_columns({row("a-name-of-some-length", 5, "short")}, 24);
  EXPECT_THAT(lines, ElementsAre("name        count  why",  //
                                 "a-name-...      5  short"));
}

TEST(Columns, AreNeverWiderThanAskedAndNeverEndInSpaces) {
  const std::vector<Row> rows{row("a-name-of-some-length", 123456, "a reason of some length"),
                              row("b", 7)};
  for (std::size_t width = 0; width < 80; ++width) {
    for (const std::string& line : in_columns(rows, width)) {
      EXPECT_LE(line.size(), width);
      EXPECT_FALSE(line.ends_with(' ')) << line;
    }
  }
}

}  // namespace
}  // namespace accord
