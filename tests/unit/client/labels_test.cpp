#include "client/render/labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace accord {
namespace {

using testing::HasSubstr;
using testing::Not;

class LabelsTest : public testing::Test {
 protected:
  Svg svg_{100, 100};
  Labels labels_{svg_};
};

TEST_F(LabelsTest, AreWrittenWhereThereIsRoom) {
  labels_.write({50, 20}, "one", 10, "");
  labels_.write({50, 40}, "below", 10, "");
  labels_.write({90, 20}, "beside", 10, "");
  EXPECT_THAT(svg_.str(), HasSubstr(">one<"));
  EXPECT_THAT(svg_.str(), HasSubstr(">below<"));
  EXPECT_THAT(svg_.str(), HasSubstr(">beside<"));
}

TEST_F(LabelsTest, AreLeftOutWhereTheyWouldRunIntoEarlierOnes) {
  labels_.write({50, 20}, "first", 10, "");
  labels_.write({50, 20}, "same", 10, "");
  labels_.write({60, 25}, "overlapping", 10, "");
  EXPECT_THAT(svg_.str(), HasSubstr(">first<"));
  EXPECT_THAT(svg_.str(), Not(HasSubstr("same")));
  EXPECT_THAT(svg_.str(), Not(HasSubstr("overlapping")));
}

TEST_F(LabelsTest, DoNotKeepOthersFromWhereTheyWereLeftOut) {
  labels_.write({50, 20}, "first", 10, "");
  labels_.write({60, 20}, "a long one", 10, "");
  labels_.write({90, 20}, "free", 10, "");
  EXPECT_THAT(svg_.str(), HasSubstr(">free<"));
}

TEST(LabelSize, ShrinksWithTheNameAndGrowsWithTheRoom) {
  EXPECT_LT(Labels::size_for("longer", 20), Labels::size_for("long", 20));
  EXPECT_LT(Labels::size_for("long", 20), Labels::size_for("long", 30));
}

}  // namespace
}  // namespace accord
