// Another robot on a known path, as a robot meets it of which not both are discs or balls: the two
// questions of MovingObstacles, answered by certified geometric queries, which are dear. What a
// body said of nodes of a roadmap it remembers, for searches of the same roadmap that follow. Not
// thread safe (holds scratch and memory).
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/model/trajectory.h"
#include "worker/interval.h"

namespace accord {

class LocalRoadmap;

class MovingBody {
 public:
  // As `robot` meets it from `from` (s) on. It parks at its path's end. It is avoided until `until`
  // (s, may be infinite). What it says of the nodes of `remembered`, a roadmap of that robot's that
  // outlives it, it remembers. The world must outlive it.
  MovingBody(const CollisionWorld& world, RobotId robot, RobotId other, Trajectory path,
             double from, double until, const LocalRoadmap* remembered = nullptr);

  // Whether it is that robot on that path, avoided until then.
  bool is(RobotId other, const Trajectory& path, double until) const;

  // A node of a roadmap, by which a place is known again.
  struct Name {
    const LocalRoadmap* roadmap;
    std::uint32_t node;
  };

  // Appends the times from `since` (s) on at which it may touch a robot that rests at q, whose
  // bounds are `here`. `name`: where q is a node's.
  void add_unsafe(ConfigurationView q, const Aabb& here, double since,
                  const std::optional<Name>& name, std::vector<Interval>& unsafe);

  // A motion into a robot that has parked stays blocked however late it departs.
  enum class Passage { kClear, kBlocked, kBlockedForGood };
  // The linear motion from a at t to b at t + duration, within `bounds`.
  Passage passage(ConfigurationView a, ConfigurationView b, const Aabb& bounds, double t,
                  double duration);

  // Geometric queries made so far.
  std::uint64_t checks() const { return checks_; }

 private:
  // A linear motion, or a rest.
  struct Piece {
    double t0, t1;  // s; t1 infinite: parked
    Configuration from, to;
    Aabb bounds;  // inflated by what must be kept
  };
  struct Known {
    double since;  // s
    std::vector<Interval> unsafe;
  };

  void find_unsafe(ConfigurationView q, const Aabb& here, double since,
                   std::vector<Interval>& unsafe);
  // Cuts a motion over [t0, t1] and a piece to the time that both share, into the scratch
  // configurations. nullopt: there is none.
  std::optional<Interval> share(const Piece& piece, ConfigurationView a, ConfigurationView b,
                                double t0, double t1);
  // First contact of a rest at q over [t0, t1] with a piece.
  std::optional<double> contact(const Piece& piece, ConfigurationView q, double t0, double t1);
  // Whether a motion has any; sooner told than when.
  bool touches(const Piece& piece, ConfigurationView a, ConfigurationView b, double t0, double t1);

  const CollisionWorld& world_;
  RobotId robot_;
  RobotId other_;
  Trajectory path_;
  double from_;   // s
  double until_;  // s
  std::vector<Piece> pieces_;
  const LocalRoadmap* remembered_;
  std::unordered_map<std::uint32_t, Known> known_;  // by node
  std::uint64_t checks_ = 0;
  Configuration mine_from_, mine_to_, other_from_, other_to_;  // scratch
};

}  // namespace accord
