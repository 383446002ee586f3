#include "worker/roadmap_evolution.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

TEST(RoadmapEvolution, NamesWhatANewNodeDoesToTheComponents) {
  RoadmapEvolution evolution(10);
  const auto a = evolution.add(Configuration{0});
  EXPECT_EQ(evolution.classify(0, true, false), NodeClass::kCreate);
  const auto b = evolution.add(Configuration{4});
  EXPECT_EQ(evolution.classify(0, true, false), NodeClass::kCreate);
  const auto c = evolution.add(Configuration{2});
  evolution.join(c, a);
  evolution.join(c, b);
  EXPECT_EQ(evolution.classify(2, false, true), NodeClass::kMerge);
  EXPECT_TRUE(evolution.connected(a, b));
  EXPECT_DOUBLE_EQ(evolution.diameter(c), 4);
  const auto d = evolution.add(Configuration{6});
  evolution.join(d, b);
  EXPECT_EQ(evolution.classify(1, true, true), NodeClass::kExpand);
  const auto e = evolution.add(Configuration{3});
  evolution.join(e, a);
  EXPECT_EQ(evolution.classify(1, false, false), NodeClass::kOversample);
}

TEST(RoadmapEvolution, SettlesOnceAWholeWindowBroughtNothing) {
  RoadmapEvolution evolution(20);
  const auto first = evolution.add(Configuration{0});
  evolution.classify(0, false, false);
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(evolution.has_settled(), i >= 19) << i;
    evolution.join(evolution.add(Configuration{0}), first);
    evolution.classify(1, false, false);
  }
  EXPECT_TRUE(evolution.has_settled());
  evolution.add(Configuration{9});
  evolution.classify(2, false, true);  // one merge opens it again
  EXPECT_FALSE(evolution.has_settled());
}

}  // namespace
}  // namespace accord
