// Counts distances that are worked out elsewhere than in a CollisionWorld, for discs and balls say,
// and hands the count to the world in the end: one addition each, where they come by the million.
// Not thread safe.
#pragma once

#include <cstdint>
#include <utility>

#include "common/geometry/collision_world.h"

namespace accord {

class DistanceTally {
 public:
  // The world must outlive this.
  explicit DistanceTally(const CollisionWorld& world) : world_(&world) {}
  ~DistanceTally() {
    if (count_ != 0) world_->count_distance_queries(count_);
  }
  DistanceTally(DistanceTally&& other) noexcept
      : world_(other.world_), count_(std::exchange(other.count_, 0)) {}
  DistanceTally(const DistanceTally&) = delete;
  DistanceTally& operator=(const DistanceTally&) = delete;
  DistanceTally& operator=(DistanceTally&&) = delete;

  void add(std::uint64_t n) { count_ += n; }

 private:
  const CollisionWorld* world_;
  std::uint64_t count_ = 0;
};

}  // namespace accord
