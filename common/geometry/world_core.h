// CollisionWorld in one dimension: what its header says, for planar (D = 2) or spatial (D = 3)
// scenes. Immutable after construction; const members may be called concurrently.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/geometry/advancement.h"
#include "common/geometry/box_tree.h"
#include "common/geometry/collision_world.h"
#include "common/geometry/query_counter.h"

namespace accord {

template <int D>
class WorldCore {
 public:
  WorldCore(const Scene& scene, double margin);

  bool is_free(RobotId robot, ConfigurationView q) const;
  std::optional<Fault> fault(RobotId robot, ConfigurationView q) const;
  bool motion_is_free(RobotId robot, ConfigurationView a, ConfigurationView b) const;
  std::optional<double> first_fault(RobotId robot, ConfigurationView a, ConfigurationView b) const;
  double obstacle_distance(RobotId robot, ConfigurationView q, double cutoff) const;
  double separation(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb,
                    double cutoff) const;
  Fault closest(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb) const;
  // As CollisionWorld's, with the way u in [0, 1] instead of time.
  std::optional<double> first_contact(RobotId a, ConfigurationView from_a, ConfigurationView to_a,
                                      RobotId b, ConfigurationView from_b,
                                      ConfigurationView to_b) const;
  bool motions_are_clear(RobotId a, ConfigurationView from_a, ConfigurationView to_a, RobotId b,
                         ConfigurationView from_b, ConfigurationView to_b) const;
  Extent<D> swept_bounds(RobotId robot, ConfigurationView a, ConfigurationView b) const;

  const Chain<D>& chain(RobotId robot) const { return chains_[robot.index()]; }
  // What robots must keep from each other and from obstacles, rounding included.
  double apart() const { return apart_; }
  QueryCounter& counter() const { return counter_; }

 private:
  using Work = Advancement<D>;

  void add_obstacles(const Scene& scene);
  void add_walls(const Scene& scene);
  void find_rounding();
  void find_what_matters();

  // A thread's workspace with one robot's motion started in it.
  Work& begin(RobotId robot, ConfigurationView from, ConfigurationView to) const;
  // The same with a second robot's and the pairs that may meet; nullptr where none may.
  Work* begin_two(RobotId a, ConfigurationView from_a, ConfigurationView to_a, RobotId b,
                  ConfigurationView from_b, ConfigurationView to_b) const;
  bool within_limits(RobotId robot, ConfigurationView q) const;
  // The u at which the motion leaves the limits; above 1 where it does not.
  double leaves_limits(RobotId robot, ConfigurationView a, ConfigurationView b) const;

  // What a motion has to be proved against: fills work.pairs. Leaves out what cannot be met.
  void add_fixed_pairs(RobotId robot, Work& work) const;
  // False where only one obstacle was asked for and there is one: the motion is not free.
  bool add_disc_pairs(RobotId robot, bool only_one, Work& work) const;
  void add_self_pairs(Work& work) const;
  void add_robot_pairs(Work& work) const;
  void add_walls_for(int piece, const Extent<D>& swept, double speed, double bend,
                     Work& work) const;
  void sweep_pieces(Work& work) const;  // fills work.extents

  // Whether a piece is inside a closed mesh or the other way round, whose surfaces do not meet; at
  // the work's first configuration.
  bool swallowed(Work& work) const;
  static bool contains(const Placed<D>& solid, const Placed<D>& other);

  Extent<D> rough_extent(RobotId robot, ConfigurationView a, ConfigurationView b) const;
  std::optional<Fault> limit_fault(RobotId robot, ConfigurationView q) const;
  Fault fault_between(const Placed<D>& a, const Placed<D>& b, Fault::Kind kind) const;

  const Scene* scene_;
  double margin_;
  double rounding_ = 0;  // m, on any distance
  double apart_ = 0;
  double self_apart_ = 0;
  std::vector<Chain<D>> chains_;
  std::vector<Piece<D>> fixed_pieces_;  // of obstacles, then the bounds' walls
  std::vector<Placed<D>> fixed_;
  std::vector<int> obstacle_of_;  // by fixed piece, walls left out
  std::vector<Extent<D>> fixed_extents_;
  BoxTree<D> tree_;
  std::optional<Extent<D>> bounds_;
  bool solids_ = false;           // some piece is a closed mesh
  std::vector<char> near_fixed_;  // by robot: an arm may reach obstacles or bounds
  mutable QueryCounter counter_;
};

}  // namespace accord
