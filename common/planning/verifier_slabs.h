// The verifier's broad phase in space and time: cuts time into slabs, boxes what each robot sweeps
// in one, and lists the pairs whose boxes come near each other. Every other pair is proved apart
// for that slab. Internal to the verifier; the planner has its own.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "common/planning/verifier_path_boxes.h"
#include "common/planning/verifier_subject.h"

namespace accord::verification {

struct Pair {
  RobotId first;  // first < second
  RobotId second;
};

class TimeSlabs {
 public:
  // Slabs are so short that paths have a few waypoints in one.
  explicit TimeSlabs(const Subject& subject);

  // The slabs cover [0, subject.end()]; after that every robot is parked where the last slab ends.
  std::size_t count() const { return count_; }

  // Told of a part of a slab, from begin to end (s), and the pairs that may come closer than the
  // distance during it, in no particular order, the same in every run. Whether to go on.
  using Visit = std::function<bool(double begin, double end, std::vector<Pair>& pairs)>;
  // Visits the parts of a slab, in the order of time. Slabs are halved where that rules out so many
  // pairs that it pays. Thread safe.
  void for_each_part(std::size_t slab, double distance, const Visit& visit) const;

 private:
  using Pairs = std::vector<Pair>;

  double begin(std::size_t slab) const;  // s
  Pairs near_pairs(double begin, double end, double distance) const;
  // Of the pairs given those that are near in [begin, end].
  Pairs still_near(const Pairs& pairs, double begin, double end, double distance) const;
  double looks(const Pairs& pairs, double begin, double end) const;
  bool descend(double begin, double end, unsigned halvings, Pairs& pairs, double distance,
               const Visit& visit) const;

  const Subject& subject_;
  std::vector<PathBoxes> boxes_;  // by RobotId
  double end_;                    // s
  std::size_t count_ = 1;
  unsigned halvings_ = 0;  // of a slab, at most
};

}  // namespace accord::verification
