#include "worker/shared_roadmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <cmath>
#include <limits>
#include <queue>
#include <thread>

#include "common/geometry/tolerances.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"
#include "worker/roadmap_query.h"
#include "worker/robot_roadmap.h"

namespace accord {
namespace {

// A room with a wall that leaves a gap at one side, and seeded nodes all over it.
class SharedRoadmapTest : public ::testing::Test {
 protected:
  SharedRoadmapTest()
      : scene_(testing::SceneBuilder(0, 0, 10, 10)
                   .box(4.5, 0, 5.5, 8)
                   .disk(0.4, {1, 1}, {9, 1})
                   .build()),
        world_(scene_, kPlanningMargin),
        roadmap_(world_, {0}, nodes()) {}

  std::vector<Configuration> nodes() const {
    RandomStream random(4);
    std::vector<Configuration> out{{1, 1}, {9, 1}};
    while (out.size() < 150) {
      const Configuration q{random.uniform(0, 10), random.uniform(0, 10)};
      if (world_.is_free({0}, q)) out.push_back(q);
    }
    return out;
  }

  // Dijkstra's algorithm over the edges whose motions are free.
  double least_time(SharedRoadmap::Node from, SharedRoadmap::Node to) const {
    std::vector<double> times(roadmap_.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, SharedRoadmap::Node>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    times[from] = 0;
    open.emplace(0, from);
    while (!open.empty()) {
      const auto [time, node] = open.top();
      open.pop();
      if (time > times[node]) continue;
      for (const RoadmapEdge& edge : roadmap_.edges(node)) {
        const bool is_free = world_.motion_is_free({0}, roadmap_.configuration(node),
                                                   roadmap_.configuration(edge.to));
        if (!is_free || times[edge.to] <= time + edge.duration) continue;
        times[edge.to] = time + edge.duration;
        open.emplace(times[edge.to], edge.to);
      }
    }
    return times[to];
  }

  double time_of(const std::vector<Configuration>& path) const {
    double time = 0;
    for (std::size_t i = 1; i < path.size(); ++i) time += roadmap_.duration(path[i - 1], path[i]);
    return time;
  }

  std::shared_ptr<const Scene> scene_;
  CollisionWorld world_;
  SharedRoadmap roadmap_;
};

TEST_F(SharedRoadmapTest, EdgesLeadBothWaysUnderOneNumber) {
  for (SharedRoadmap::Node node = 0; node < roadmap_.size(); ++node) {
    for (const RoadmapEdge& edge : roadmap_.edges(node)) {
      ASSERT_LT(edge.id, roadmap_.edge_count());
      const auto back = std::ranges::find(roadmap_.edges(edge.to), node, &RoadmapEdge::to);
      ASSERT_NE(back, roadmap_.edges(edge.to).end());
      EXPECT_EQ(back->id, edge.id);
    }
  }
}

TEST_F(SharedRoadmapTest, WhatItRemembersOfAnEdgeIsWhatTheWorldSays) {
  std::size_t blocked = 0;
  for (int round = 0; round < 2; ++round) {
    for (SharedRoadmap::Node node = 0; node < roadmap_.size(); ++node) {
      for (const RoadmapEdge& edge : roadmap_.edges(node)) {
        const bool is_free = world_.motion_is_free({0}, roadmap_.configuration(node),
                                                   roadmap_.configuration(edge.to));
        EXPECT_EQ(roadmap_.is_free(node, edge), is_free);
        blocked += !is_free;
      }
    }
  }
  EXPECT_GT(blocked, 0u) << "no edge runs into the wall: the test shows little";
}

TEST_F(SharedRoadmapTest, FindsTheShortestPathPastTheWall) {
  Effort effort;
  const auto path = shortest_path(roadmap_, Configuration{1, 1}, Configuration{9, 1}, effort);
  ASSERT_TRUE(path);
  for (std::size_t i = 1; i < path->size(); ++i) {
    EXPECT_TRUE(world_.motion_is_free({0}, (*path)[i - 1], (*path)[i]));
  }
  // Start and goal are nodes as well, so that joining them anew cannot make it longer.
  EXPECT_LE(time_of(*path), least_time(0, 1) + 1e-6);
  EXPECT_GT(time_of(*path), 14) << "straight through the wall";
}

TEST_F(SharedRoadmapTest, CountsTheSameEffortWhoeverHasProvedEdgesBefore) {
  Effort first, second;
  const Configuration start{1, 1}, goal{9, 1};
  const auto path = shortest_path(roadmap_, start, goal, first);
  EXPECT_EQ(shortest_path(roadmap_, start, goal, second), path);
  EXPECT_EQ(first.motion_checks, second.motion_checks);
  EXPECT_EQ(first.expansions, second.expansions);
}

// Two threads that asked for the same edge at the same time would both prove it, and the count of
// distances would differ from run to run.
TEST_F(SharedRoadmapTest, ProvesAnEdgeOnceHoweverManyAskForIt) {
  const auto ask_for_all = [](const SharedRoadmap& roadmap) {
    for (SharedRoadmap::Node node = 0; node < roadmap.size(); ++node) {
      for (const RoadmapEdge& edge : roadmap.edges(node)) roadmap.is_free(node, edge);
    }
  };
  const std::uint64_t before = world_.distance_queries();
  ask_for_all(roadmap_);
  const std::uint64_t once = world_.distance_queries() - before;
  EXPECT_GT(once, 0u);
  for (int round = 0; round < 200; ++round) {
    const SharedRoadmap fresh(world_, {0}, nodes());
    const std::uint64_t begin = world_.distance_queries();
    std::barrier at_once(2);
    const auto ask = [&] {
      at_once.arrive_and_wait();
      ask_for_all(fresh);
    };
    std::jthread other(ask);
    ask();
    other.join();
    EXPECT_EQ(world_.distance_queries() - begin, once);
  }
}

TEST(SharedRoadmap, HasNoPathWhereTheWallIsWhole) {
  const auto scene =
      testing::SceneBuilder(0, 0, 10, 10).box(4.5, 0, 5.5, 10).disk(0.4, {1, 1}, {9, 1}).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const SharedRoadmap roadmap(world, {0}, {{1, 1}, {2, 5}, {3, 8}, {7, 8}, {8, 5}, {9, 1}});
  Effort effort;
  EXPECT_FALSE(shortest_path(roadmap, Configuration{1, 1}, Configuration{9, 1}, effort));
}

// Who parks in an open hall must leave a way past on the roadmap for traffic.
TEST(RobotRoadmap, LeadsRoundWhereOthersPark) {
  const auto scene =
      testing::SceneBuilder(0, 0, 8, 8).disk(0.4, {1, 4}, {7, 4}).disk(0.4, {4, 4}, {4, 4}).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const RobotRoadmap roadmap(world, {0});
  const SharedRoadmap& dense = roadmap.dense();
  std::size_t around = 0;
  for (SharedRoadmap::Node node = 0; node < dense.size(); ++node) {
    EXPECT_TRUE(world.is_free({0}, dense.configuration(node)));
    const ConfigurationView q = dense.configuration(node);
    const double away = std::hypot(q[0] - 4, q[1] - 4);
    around += away > 0.8 && away < 1.0;
  }
  EXPECT_GE(around, 8u);
}

}  // namespace
}  // namespace accord
