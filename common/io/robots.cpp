#include "common/io/robots.h"

#include <string>
#include <unordered_map>

#include "common/io/configuration_checks.h"
#include "common/io/fields.h"
#include "common/io/limits.h"
#include "common/io/planar_checks.h"
#include "common/io/words.h"

namespace accord {
namespace {

std::optional<Configuration> read_configuration(const Value& value, const RobotModel& model,
                                                Faults& faults) {
  if (!value.is_list() || value.size() != model.dof()) {
    fault_at(value, "expected " + configuration_in_words(model) + ", not " + value.in_words(),
             faults);
    return std::nullopt;
  }
  Configuration q;
  bool sound = true;
  for (const Value item : value) {
    const std::size_t i = q.size();
    const auto number = read_number(item, range_of(model, i), faults);
    const auto fault = number ? limit_fault(model.dofs[i], *number) : std::nullopt;
    if (fault) fault_at(item, *fault, faults);
    sound = number && !fault && sound;
    q.push_back(number.value_or(0));
  }
  if (!sound) return std::nullopt;
  return q;
}

class RobotsReader {
 public:
  RobotsReader(const Models* models, SceneContext& context)
      : models_(models), context_(context), faults_(context.faults) {}

  std::vector<PlacedRobot> read(const Value& list) {
    std::vector<PlacedRobot> robots;
    for (const Value value : list) {
      if (faults_.full()) break;
      if (auto robot = read_robot(value)) robots.push_back(std::move(*robot));
    }
    return robots;
  }

 private:
  std::optional<PlacedRobot> read_robot(const Value& value) {
    if (!expect_map(value, "a robot: a map of name, model, start, goal", faults_)) {
      return std::nullopt;
    }
    const Fields fields(value, "a robot", {"name", "model", "start", "goal", "at", "rpy"}, faults_);
    PlacedRobot placed{{read_unique_name(fields), find_model(fields), Pose::Identity(), {}, {}},
                       value,
                       std::nullopt,
                       std::nullopt};
    Robot& robot = placed.robot;
    const auto start = fields.require("start", "a configuration");
    const auto goal = fields.require("goal", "a configuration");
    if (!robot.model) return std::nullopt;
    const auto base = read_base(fields, *robot.model);
    if (start && read_query(*start, *robot.model, robot.start)) placed.start = start;
    if (goal && read_query(*goal, *robot.model, robot.goal)) placed.goal = goal;
    if (!base || !can_stand(robot, *base, value)) return std::nullopt;
    return placed;
  }

  // Reads a start or a goal into `q`, unless it is at fault.
  bool read_query(const Value& value, const RobotModel& model, Configuration& q) {
    const auto read = read_configuration(value, model, faults_);
    if (read) q = *read;
    return read.has_value();
  }

  // Puts the robot on its base; false where the scene has no room for its bodies there.
  bool can_stand(Robot& robot, const Pose& base, const Value& value) {
    robot.base = base;
    const auto blame = [&](std::string_view text) { fault_at(value, text, faults_); };
    if (!afford(robot, blame)) return false;
    const std::size_t before = faults_.count();
    if (context_.space == Space::kPlanar) check_planar_bodies(robot, blame);
    return faults_.count() == before;
  }

  // Without a name of its own, a robot goes by its place in the file in what is said of it.
  std::string read_unique_name(const Fields& fields) {
    const auto value = fields.require("name", "a name of its own");
    const auto name = value ? read_name(*value, faults_) : std::nullopt;
    if (!name) return fields.map().path();
    const auto [first, is_new] = names_.emplace(*name, value->line());
    if (!is_new) {
      fault_at(*value,
               in_quotes(*name) + " is the name of another robot, in line " +
                   std::to_string(first->second),
               faults_);
      return fields.map().path();
    }
    return *name;
  }

  // Null where there is none, or where the models themselves are at fault.
  std::shared_ptr<const RobotModel> find_model(const Fields& fields) {
    const auto value = fields.require("model", "the name of a model");
    const auto name = value ? read_name(*value, faults_) : std::nullopt;
    if (!name) return nullptr;
    if (models_ == nullptr) return nullptr;
    const auto found = models_->find(*name);
    if (found != models_->end()) return found->second;
    std::vector<std::string_view> known;
    for (const auto& [other, model] : *models_) known.push_back(other);
    fault_at(*value, "unknown model " + in_quotes(*name) + suggestion(*name, known), faults_);
    return nullptr;
  }

  // nullopt where it is not known where the robot stands.
  std::optional<Pose> read_base(const Fields& fields, const RobotModel& model) {
    if (model.kind == RobotKind::kArm) return read_pose(fields, context_.space, faults_);
    for (const std::string_view key : {"at", "rpy"}) {
      if (const auto value = fields.find(key)) {
        fault_at(*value,
                 "a " + std::string(kind_in_words(model.kind)) +
                     " stands where its start says; only arms have a base to place",
                 faults_);
      }
    }
    return Pose::Identity();
  }

  bool afford(const Robot& robot, const Blame& blame) {
    bodies_ += robot.model->bodies.size();
    if (bodies_ <= limits::kSceneBodies) return true;
    blame("the scene's robots have more than " + std::to_string(limits::kSceneBodies) +
          " bodies together");
    return false;
  }

  const Models* models_;
  SceneContext& context_;
  Faults& faults_;
  std::unordered_map<std::string, int> names_;  // with the line of the first
  std::size_t bodies_ = 0;
};

}  // namespace

std::vector<PlacedRobot> read_robots(const Value& list, const Models* models,
                                     SceneContext& context) {
  if (!expect_list(list, "robots", context.faults)) return {};
  const std::size_t count = list.size();
  if (count == 0 || count > limits::kRobots) {
    fault_at(list,
             "expected 1 to " + std::to_string(limits::kRobots) + " robots, not " +
                 std::to_string(count),
             context.faults);
    return {};
  }
  return RobotsReader(models, context).read(list);
}

std::string_view kind_in_words(RobotKind kind) {
  switch (kind) {
    case RobotKind::kDisk:
      return "disk";
    case RobotKind::kFootprint:
      return "footprint";
    case RobotKind::kBall:
      return "ball";
    case RobotKind::kArm:
      return "arm";
  }
  return "";
}

}  // namespace accord
