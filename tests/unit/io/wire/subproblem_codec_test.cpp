#include "common/io/wire/subproblem_codec.h"

#include <gtest/gtest.h>

#include <bit>

#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;

void expect_same(const Task& a, const Task& b) {
  EXPECT_EQ(a.robot, b.robot);
  EXPECT_EQ(a.version, b.version);
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.to, b.to);
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_EQ(a.region.lower, b.region.lower);
  EXPECT_EQ(a.region.upper, b.region.upper);
  EXPECT_EQ(a.guide, b.guide);
  EXPECT_EQ(a.tail, b.tail);
  EXPECT_EQ(a.roadmap_level, b.roadmap_level);
}

void expect_same(const Subproblem& a, const Subproblem& b) {
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a.from), std::bit_cast<std::uint64_t>(b.from));
  EXPECT_EQ(a.to, b.to);
  EXPECT_EQ(a.horizon, b.horizon);
  EXPECT_EQ(a.clear_until, b.clear_until);
  EXPECT_EQ(a.lockstep, b.lockstep);
  EXPECT_EQ(a.whole, b.whole);
  ASSERT_EQ(a.tasks.size(), b.tasks.size());
  for (std::size_t i = 0; i < a.tasks.size(); ++i) expect_same(a.tasks[i], b.tasks[i]);
  ASSERT_EQ(a.outsiders.size(), b.outsiders.size());
  for (std::size_t i = 0; i < a.outsiders.size(); ++i) {
    EXPECT_EQ(a.outsiders[i].robot, b.outsiders[i].robot);
    EXPECT_EQ(a.outsiders[i].version, b.outsiders[i].version);
    EXPECT_EQ(a.outsiders[i].path, b.outsiders[i].path);
    EXPECT_EQ(a.outsiders[i].until, b.outsiders[i].until);
  }
  EXPECT_EQ(a.limits.query_expansions, b.limits.query_expansions);
  EXPECT_EQ(a.limits.query_checks, b.limits.query_checks);
  EXPECT_EQ(a.limits.priority_orders, b.limits.priority_orders);
  EXPECT_EQ(a.limits.decoupled_samples, b.limits.decoupled_samples);
  EXPECT_EQ(a.limits.composite_nodes, b.limits.composite_nodes);
  EXPECT_EQ(a.limits.composite_window_per_dof, b.limits.composite_window_per_dof);
  EXPECT_EQ(a.limits.last_factor, b.limits.last_factor);
}

TEST(SubproblemCodec, BringsRandomSubproblemsBackToTheBit) {
  RandomStream random(4);
  for (const char* name : {"mixed-floor.yaml", "panda-four.yaml", "drones-12.yaml"}) {
    const auto scene = load_example(name);
    for (int i = 0; i < 200; ++i) {
      const Subproblem subproblem = random_subproblem(random, *scene);
      const Bytes bytes = encode_subproblem(subproblem);
      const auto decoded = decode_subproblem(bytes, *scene);
      ASSERT_TRUE(decoded) << decoded.error();
      expect_same(subproblem, *decoded);
      ASSERT_EQ(encode_subproblem(*decoded), bytes);
    }
  }
}

TEST(SubproblemCodec, TakesARobotThatIsPlannedAloneAndHasNoPathYet) {
  const auto scene = small_scene();
  Subproblem initial;
  initial.horizon = std::numeric_limits<double>::infinity();
  const Region whole{{-5, -3}, {5, 3}};
  initial.tasks.push_back({{1}, 0, {4, 0}, 0, {-4, 0}, whole, {}, {}, -1});
  const auto decoded = decode_subproblem(encode_subproblem(initial), *scene);
  ASSERT_TRUE(decoded) << decoded.error();
  expect_same(initial, *decoded);
}

TEST(SubproblemCodec, TakesTheLimitsOfBaselines) {
  const auto scene = small_scene();
  RandomStream random(1);
  Subproblem subproblem = random_subproblem(random, *scene);
  subproblem.limits = SolverLimits::unlimited();
  const auto decoded = decode_subproblem(encode_subproblem(subproblem), *scene);
  ASSERT_TRUE(decoded) << decoded.error();
  expect_same(subproblem, *decoded);
}

TEST(HierarchyCodec, KeepsNamesAndTheirOrder) {
  const std::vector<std::string> solvers{"prioritized-query", "composite-prm"};
  const auto decoded = decode_hierarchy(encode_hierarchy(solvers));
  ASSERT_TRUE(decoded) << decoded.error();
  EXPECT_EQ(decoded->solvers, solvers);
  EXPECT_EQ(decoded->request, "");
  const auto labelled = decode_hierarchy(encode_hierarchy(solvers, "depot-7"));
  ASSERT_TRUE(labelled) << labelled.error();
  EXPECT_EQ(labelled->solvers, solvers);
  EXPECT_EQ(labelled->request, "depot-7");
}

TEST(HierarchyCodec, RefusesNoneAndTooMany) {
  EXPECT_FALSE(decode_hierarchy({}));
  EXPECT_FALSE(decode_hierarchy(encode_hierarchy(std::vector<std::string>(17, "cbs-mp"))));
  EXPECT_FALSE(decode_hierarchy(encode_hierarchy({"line\nbreak"})));
  EXPECT_TRUE(decode_hierarchy(
      encode_hierarchy(std::vector<std::string>(16, "cbs-mp"), std::string(128, 'a'))));
}

// What it holds is written to a log.
TEST(HierarchyCodec, RefusesARequestThatHasNoSuchId) {
  const auto decoded = decode_hierarchy(encode_hierarchy({"cbs-mp"}, "line\nbreak"));
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error(), "request: expected 1 to 128 letters, digits, '-', '_', '.' and ':'");
  EXPECT_FALSE(decode_hierarchy(encode_hierarchy({"cbs-mp"}, std::string(129, 'a'))));
}

}  // namespace
}  // namespace accord
