// The verifier's broad phase in space and time: cuts time into slabs, boxes what each robot sweeps
// in one, and lists the pairs whose boxes come near each other. Every other pair is proved apart
// for that slab. Internal to the verifier; the planner has its own.
#pragma once

#include <cstddef>
#include <vector>

#include "common/planning/verifier_subject.h"

namespace accord::verification {

struct Pair {
  RobotId first;  // first < second
  RobotId second;
};

class TimeSlabs {
 public:
  // Slabs are so short that a robot moves about its own size in one, on average.
  explicit TimeSlabs(const Subject& subject);

  // The slabs cover [0, subject.end()]; after that every robot is parked where the last slab ends.
  std::size_t count() const { return count_; }
  double begin(std::size_t slab) const;  // s
  double end(std::size_t slab) const;    // s

  // The pairs that may come closer than `distance` (m) during the slab, in ascending order.
  // Thread safe.
  std::vector<Pair> near_pairs(std::size_t slab, double distance) const;

 private:
  Aabb swept_box(RobotId id, double t0, double t1) const;

  const Subject& subject_;
  double end_;
  std::size_t count_;
};

}  // namespace accord::verification
