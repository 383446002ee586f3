#include "common/io/wire/resolution_codec.h"

#include <gtest/gtest.h>

#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;

TEST(ResolutionCodec, BringsRandomResolutionsBackToTheBit) {
  RandomStream random(9);
  const auto scene = load_example("mixed-floor.yaml");
  for (int i = 0; i < 300; ++i) {
    const Subproblem subproblem = random_subproblem(random, *scene);
    const Resolution resolution = random_resolution(random, subproblem);
    const Bytes bytes = encode_resolution(resolution);
    const auto decoded = decode_resolution(bytes, *scene, subproblem);
    ASSERT_TRUE(decoded) << decoded.error();
    EXPECT_EQ(decoded->solved, resolution.solved);
    EXPECT_EQ(decoded->solver, resolution.solver);
    EXPECT_EQ(decoded->roadmap_level, resolution.roadmap_level);
    EXPECT_EQ(decoded->end, resolution.end);
    EXPECT_EQ(decoded->paths, resolution.paths);
    EXPECT_EQ(decoded->left, resolution.left);
    EXPECT_EQ(decoded->effort.searches, resolution.effort.searches);
    EXPECT_EQ(decoded->effort.expansions, resolution.effort.expansions);
    EXPECT_EQ(decoded->effort.samples, resolution.effort.samples);
    EXPECT_EQ(decoded->effort.motion_checks, resolution.effort.motion_checks);
    EXPECT_EQ(decoded->effort.distance_queries, resolution.effort.distance_queries);
    ASSERT_EQ(encode_resolution(*decoded), bytes);
  }
}

TEST(ResolutionCodec, TakesOneThatIsExhausted) {
  RandomStream random(2);
  const auto scene = small_scene();
  const Subproblem subproblem = random_subproblem(random, *scene);
  EXPECT_TRUE(decode_resolution(encode_resolution({}), *scene, subproblem));
}

TEST(ResolutionCodec, RefusesOneThatAnswersAnotherSubproblem) {
  RandomStream random(3);
  const auto scene = small_scene();
  Subproblem subproblem = random_subproblem(random, *scene);
  Resolution resolution = random_resolution(random, subproblem);
  while (!resolution.solved) resolution = random_resolution(random, subproblem);
  resolution.paths.pop_back();
  const auto decoded = decode_resolution(encode_resolution(resolution), *scene, subproblem);
  ASSERT_FALSE(decoded);
  EXPECT_TRUE(decoded.error().starts_with("paths: expected ")) << decoded.error();
}

}  // namespace
}  // namespace accord
