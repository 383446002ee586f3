#include "worker/free_samples.h"

#include "common/planning/random.h"
#include "common/planning/region.h"

namespace accord {
namespace {

constexpr std::size_t kTriesPerSample = 8;
// A bridge spans up to this share of the region in each direction.
constexpr double kBridgeSpan = 0.1;
constexpr std::uint64_t kSeed =
    0x726f61646d6170;  // the roadmap belongs to the scene, not a request

}  // namespace

std::vector<Configuration> free_samples(const CollisionWorld& world, RobotId robot,
                                        std::size_t count) {
  const Region region = whole_region(world.scene(), robot);
  RandomStream random(combine({kSeed, robot.value}));
  std::vector<Configuration> samples;
  Configuration q(region.lower.size()), other(q.size());
  for (std::size_t i = 0; i < count * kTriesPerSample && samples.size() < count; ++i) {
    sample_region(region, i, kSeed, q);
    if (world.is_free(robot, q)) {
      samples.push_back(q);
      continue;
    }
    for (std::size_t k = 0; k < q.size(); ++k) {
      const double span = kBridgeSpan * (region.upper[k] - region.lower[k]);
      other[k] = q[k] + random.uniform(-span, span);
    }
    if (world.is_free(robot, other)) continue;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] = 0.5 * (q[k] + other[k]);
    if (world.is_free(robot, q)) samples.push_back(q);
  }
  return samples;
}

}  // namespace accord
