#include <optional>
#include <unordered_set>
#include <vector>

#include "accord.pb.h"
#include "common/geometry/planar_cut.h"
#include "common/io/planar_checks.h"
#include "common/io/wire/model_decoder.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/shape_decoder.h"
#include "common/io/wire/trajectory_parts.h"
#include "common/io/words.h"

namespace accord {
namespace {

// A scene is named as its file may be; obstacles made of a map, after the map and their cells.
constexpr std::size_t kSceneNameBytes = 4096;
constexpr std::size_t kObstacleNameBytes = 2 * limits::kNameBytes;
// Obstacles made of a map lie apart from where the map does.
constexpr double kObstacleReach = 4 * limits::kCoordinate;

class SceneDecoder {
 public:
  bool take(const payload::Scene& from) {
    out_.name = from.name();
    out_.timestep = from.timestep();
    out_.clearance = from.clearance();
    out_.planar = from.planar();
    return inspector_.count(out_.name.size(), 0, kSceneNameBytes, "bytes", PayloadPath("name")) &&
           inspector_.number(out_.timestep, {limits::kMinTimestep, limits::kTimestep, "s"},
                             PayloadPath("timestep")) &&
           inspector_.number(out_.clearance, {0, limits::kSize, "m"}, PayloadPath("clearance")) &&
           take_bounds(from) && shapes_.take_meshes(from) && take_models(from) &&
           take_obstacles(from) && take_robots(from);
  }

  const std::optional<std::string>& fault() const { return inspector_.fault(); }
  Scene& scene() { return out_; }

 private:
  bool take_bounds(const payload::Scene& from) {
    const WireDoubles& numbers = from.bounds();
    const PayloadPath bounds("bounds");
    if (numbers.empty()) return !out_.planar || inspector_.fail(bounds, "planar scenes have some");
    if (!inspector_.numbers(numbers, 6, kCoordinateRange, bounds)) return false;
    out_.bounds =
        Bounds{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    const int dimensions = out_.planar ? 2 : 3;
    for (int axis = 0; axis < dimensions; ++axis) {
      if (out_.bounds->max[axis] - out_.bounds->min[axis] >= limits::kMinSize) continue;
      return inspector_.fail(bounds, "the first corner must be less than the second");
    }
    return true;
  }

  bool take_models(const payload::Scene& from) {
    const auto size = static_cast<std::size_t>(from.models_size());
    if (!inspector_.count(size, 1, limits::kModels, "", PayloadPath("models"))) return false;
    for (std::size_t i = 0; i < size; ++i) {
      auto model = std::make_shared<RobotModel>();
      if (!take_model(from.models(static_cast<int>(i)), out_.planar, PayloadPath("models", i),
                      shapes_, inspector_, *model)) {
        return false;
      }
      models_.push_back(std::move(model));
    }
    return true;
  }

  bool take_obstacles(const payload::Scene& from) {
    const auto size = static_cast<std::size_t>(from.obstacles_size());
    if (!inspector_.count(size, 0, limits::kObstacles, "", PayloadPath("obstacles"))) return false;
    out_.obstacles.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at("obstacles", i);
      const payload::Obstacle& one = from.obstacles(static_cast<int>(i));
      Obstacle obstacle{one.name(), Sphere{}, Pose::Identity()};
      if (!inspector_.name(obstacle.name, PayloadPath(at, "name"), kObstacleNameBytes) ||
          !shapes_.take(one.shape(), out_.planar, PayloadPath(at, "shape"), obstacle.shape) ||
          !inspector_.pose(one.pose(), kObstacleReach, PayloadPath(at, "pose"), obstacle.pose)) {
        return false;
      }
      if (out_.planar) {
        if (const auto cut = planar_cut(obstacle.shape, obstacle.pose); !cut) {
          return inspector_.fail(at, cut.error());
        }
      }
      out_.obstacles.push_back(std::move(obstacle));
    }
    return true;
  }

  bool take_robots(const payload::Scene& from) {
    const auto size = static_cast<std::size_t>(from.robots_size());
    if (!inspector_.count(size, 1, limits::kRobots, "", PayloadPath("robots"))) return false;
    out_.robots.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
      if (!take_robot(from.robots(static_cast<int>(i)), PayloadPath("robots", i))) return false;
    }
    return true;
  }

  bool take_robot(const payload::Robot& from, const PayloadPath& at) {
    Robot robot;
    robot.name = from.name();
    const PayloadPath name(at, "name");
    const PayloadPath base(at, "base");
    if (!inspector_.name(robot.name, name)) return false;
    if (!names_.insert(robot.name).second) return inspector_.fail(name, "another robot has it");
    if (!inspector_.index(from.model(), models_.size(), "model", PayloadPath(at, "model")) ||
        !inspector_.pose(from.base(), limits::kCoordinate, base, robot.base)) {
      return false;
    }
    robot.model = models_[from.model()];
    bodies_ += robot.model->bodies.size();
    const bool mobile = robot.model->kind != RobotKind::kArm;
    if (mobile && !out_.bounds) return inspector_.fail(at, "mobile robots need bounds");
    if (mobile && robot.base.matrix() != Pose::Identity().matrix()) {
      return inspector_.fail(base, "only arms have a base to place");
    }
    if (!inspector_.count(bodies_, 0, limits::kSceneBodies, "bodies of all robots", at) ||
        !take_query(from.start(), *robot.model, PayloadPath(at, "start"), robot.start) ||
        !take_query(from.goal(), *robot.model, PayloadPath(at, "goal"), robot.goal) ||
        !(mobile || !out_.planar || stands_in_plane(robot, at))) {
      return false;
    }
    out_.robots.push_back(std::move(robot));
    return true;
  }

  bool take_query(const WireDoubles& from, const RobotModel& model, const PayloadPath& at,
                  Configuration& out) {
    if (!inspector_.numbers(from, model.dof(), kCoordinateRange, at)) return false;
    out = take_numbers(from);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const DegreeOfFreedom& dof = model.dofs[k];
      if (!inspector_.number(out[k], {dof.lower, dof.upper, ""}, PayloadPath(at, "", k))) {
        return false;
      }
    }
    return true;
  }

  bool stands_in_plane(const Robot& robot, const PayloadPath& at) {
    check_planar_bodies(robot, [&](std::string_view text) { inspector_.fail(at, text); });
    return !inspector_.fault();
  }

  Scene out_;
  Inspector inspector_;
  ShapeDecoder shapes_{inspector_};
  std::vector<std::shared_ptr<const RobotModel>> models_;
  std::unordered_set<std::string> names_;  // of robots
  std::size_t bodies_ = 0;                 // of all robots
};

}  // namespace

tl::expected<std::shared_ptr<const Scene>, std::string> decode_scene(BytesView bytes) {
  payload::Scene message;
  const ScanLimits limits{limits::kSceneWireBytes, limits::kSceneWireParts};
  if (auto fault = parse_payload(bytes, "a scene", limits, message)) {
    return tl::unexpected(std::move(*fault));
  }
  SceneDecoder decoder;
  if (!decoder.take(message)) return tl::unexpected(*decoder.fault());
  return std::make_shared<const Scene>(std::move(decoder.scene()));
}

}  // namespace accord
