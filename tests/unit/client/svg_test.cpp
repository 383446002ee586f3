#include "client/render/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace accord {
namespace {

using testing::HasSubstr;

TEST(Svg, EscapesWhatXmlWouldTakeForMarkup) {
  Svg svg(10, 10);
  svg.text({1, 2}, "a<b & \"c\">d");
  EXPECT_THAT(svg.str(), HasSubstr("a&lt;b &amp; &quot;c&quot;&gt;d"));
}

TEST(LineData, WritesTenthsOfAPixelWithoutWaste) {
  const std::vector<Vec2> points{{0, 0}, {1.04, -0.26}, {10, 2.5}};
  EXPECT_EQ(line_data(points, false), "M0 0L1 -.3 10 2.5");
  EXPECT_EQ(line_data(points, true), "M0 0L1 -.3 10 2.5Z");
}

TEST(LineData, LeavesOutPointsThatNobodyCouldTellApart) {
  const std::vector<Vec2> points{{0, 0}, {0.01, 0.01}, {0.02, 0}, {5, 5}};
  EXPECT_EQ(line_data(points, false), "M0 0L5 5");
  const std::vector<Vec2> rest{{1, 1}, {1.01, 1}};
  EXPECT_EQ(line_data(rest, false), "");
}

}  // namespace
}  // namespace accord
