// What a robot is: its degrees of freedom with their limits, its bodies, and where it stands.
// Immutable once built (io/ builds it from a scene); safe to share between threads.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/model/configuration.h"
#include "common/model/shape.h"

namespace accord {

enum class RobotKind {
  kDisk,       // q = x y            planar, one Sphere (its cut is the disc)
  kFootprint,  // q = x y heading    planar, one Polygon
  kBall,       // q = x y z          spatial, one Sphere
  kArm,        // q = movable joints in document order, fixed base
};

struct DegreeOfFreedom {
  std::string name;
  double lower;     // -infinity where unbounded
  double upper;     // +infinity where unbounded
  double velocity;  // rad/s or m/s, > 0; for translations of mobile robots see RobotModel::speed
  bool wraps;       // values that differ by a multiple of 2 pi are the same place (heading,
                    // continuous joint); such a degree of freedom has no bounds
};

enum class JointType { kFixed, kRevolute, kPrismatic };

// Moves `child` against `parent`: child frame = parent frame * origin * motion about or along
// `axis` (unit, in the joint's frame) by q[dof].
struct Joint {
  std::string name;
  JointType type;
  int parent;  // link index
  int child;   // link index
  Pose origin;
  Vec3 axis;
  int dof;  // index into q; -1 for fixed joints
};

struct Body {
  std::string name;  // the link's name, for messages
  int link;          // the link that carries it
  Shape shape;
  Pose pose;  // in the link's frame
};

// Shared by all robots that name the same model.
struct RobotModel {
  std::string name;
  RobotKind kind;
  std::vector<DegreeOfFreedom> dofs;
  double speed = 0;  // m/s: bound on the Euclidean norm of the translational velocity of the kinds
                     // kDisk, kFootprint (x, y) and kBall (x, y, z); unused for arms

  // Arms: link 0 is the root; joints are sorted so that parents come before children. Mobile
  // kinds: one link, no joints.
  std::vector<std::string> links;
  std::vector<Joint> joints;
  std::vector<Body> bodies;
  // Pairs of links, first < second, that are never checked against each other: joined by a joint
  // (fixed joints in between do not count), on the same rigid group, or disabled by the SRDF.
  std::set<std::pair<int, int>> may_touch;

  std::size_t dof() const { return dofs.size(); }
  // Number of leading degrees of freedom that `speed` bounds together: 2, 2, 3, 0.
  std::size_t translations() const;
};

// b - a, degrees of freedom that wrap taken the shorter way round (into [-pi, pi]).
// Requires: a, b and out have model.dof() numbers.
void difference(const RobotModel& model, ConfigurationView a, ConfigurationView b,
                std::span<double> out);

// b in the numbers that lie nearest to a: degrees of freedom that wrap moved by whole turns, all
// others, and those already within half a turn, exactly as they are. out may alias b.
void nearest_representation(const RobotModel& model, ConfigurationView a, ConfigurationView b,
                            std::span<double> out);

// The least time (s) in which a robot can move linearly by `delta` (numbers as written, nothing
// is wrapped) within its speed and velocity limits. Rounded up by kSpeedMargin, so that rounding of
// times further on cannot push a motion past a limit.
double least_duration(const RobotModel& model, std::span<const double> delta);

// Relative reserve that planned motions keep to velocity limits.
inline constexpr double kSpeedMargin = 1e-7;

struct Robot {
  std::string name;
  std::shared_ptr<const RobotModel> model;
  Pose base;  // where the robot stands; identity for mobile kinds without `at`
  Configuration start;
  Configuration goal;
};

}  // namespace accord
