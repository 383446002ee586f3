#include "coordinator/dispatch/warm_roadmaps.h"

#include <gtest/gtest.h>

namespace accord {
namespace {

using Warmth = WarmRoadmaps::Warmth;
constexpr EndpointId kOne{1}, kTwo{2};
const SceneHash kScene{};
const RoadmapPartners kPairs{1, 0, 3, 2};

Warmth warmth(const WarmRoadmaps& roadmaps, std::vector<RoadmapPlace> places, EndpointId worker) {
  return roadmaps.warmth(kScene, places, kPairs, worker);
}

TEST(WarmRoadmaps, AreColdInAnotherScene) {
  WarmRoadmaps roadmaps;
  EXPECT_EQ(warmth(roadmaps, {0}, kOne), Warmth::kCold);
  SceneHash other{};
  other.bytes[0] = 1;
  roadmaps.add(other, std::vector<RoadmapPlace>{0}, kOne);
  EXPECT_EQ(warmth(roadmaps, {0}, kOne), Warmth::kCold);
}

TEST(WarmRoadmaps, AreThoseOfTheTasksThatAWorkerWasGiven) {
  WarmRoadmaps roadmaps;
  roadmaps.add(kScene, std::vector<RoadmapPlace>{0}, kOne);
  EXPECT_EQ(warmth(roadmaps, {0}, kOne), Warmth::kWarm);
  EXPECT_EQ(warmth(roadmaps, {0}, kTwo), Warmth::kElsewhere);
  EXPECT_EQ(warmth(roadmaps, {1}, kOne), Warmth::kBesideWarm);
  EXPECT_EQ(warmth(roadmaps, {1}, kTwo), Warmth::kBesideElsewhere);
  EXPECT_EQ(warmth(roadmaps, {2}, kOne), Warmth::kCold);
}

TEST(WarmRoadmaps, CountForATaskAsTheColdestThatItNeeds) {
  WarmRoadmaps roadmaps;
  roadmaps.add(kScene, std::vector<RoadmapPlace>{0, 1}, kOne);
  roadmaps.add(kScene, std::vector<RoadmapPlace>{2}, kTwo);
  EXPECT_EQ(warmth(roadmaps, {0, 1}, kOne), Warmth::kWarm);
  EXPECT_EQ(warmth(roadmaps, {0, 2}, kOne), Warmth::kElsewhere);
  EXPECT_EQ(warmth(roadmaps, {0, 3}, kOne), Warmth::kBesideElsewhere);
  EXPECT_EQ(warmth(roadmaps, {2, 3}, kTwo), Warmth::kBesideWarm);
}

TEST(WarmRoadmaps, AreLostWithTheirWorkerOrScene) {
  WarmRoadmaps roadmaps;
  roadmaps.add(kScene, std::vector<RoadmapPlace>{0}, kOne);
  roadmaps.forget(kOne);
  EXPECT_EQ(warmth(roadmaps, {0}, kTwo), Warmth::kCold);
  roadmaps.add(kScene, std::vector<RoadmapPlace>{0}, kOne);
  roadmaps.forget(kScene);
  EXPECT_EQ(warmth(roadmaps, {0}, kOne), Warmth::kCold);
}

}  // namespace
}  // namespace accord
