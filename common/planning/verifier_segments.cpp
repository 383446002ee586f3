#include "common/planning/verifier_segments.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "common/planning/verifier_words.h"

namespace accord::verification {
namespace {

// Room for the rounding of whoever wrote the times (s).
constexpr double kRounding = 1e-9;

bool same_time(double a, double b) {
  return std::abs(a - b) <= kRounding;  // false where one is not a number
}

Violation malformed(const RobotPlan& robot, std::size_t segment, const std::string& what) {
  const double from = robot.segments[segment].from;
  return {Violation::Kind::kForm,
          {robot.name},
          std::isfinite(from) ? from : 0,
          Vec3::Zero(),
          0,
          quoted(robot.name) + ", segment " + std::to_string(segment) + ": " + what};
}

// Looks names up in constant time: crowds of hundreds are named in each segment of each of them.
class Names {
 public:
  explicit Names(const Scene& scene) : last_naming_(scene.robots.size(), 0) {
    for (std::size_t i = 0; i < scene.robots.size(); ++i) index_.emplace(scene.robots[i].name, i);
  }

  // What is wrong with the names of a segment of `self`; nullopt: nothing.
  std::optional<std::string> check(const std::string& self, const std::vector<std::string>& names) {
    ++naming_;
    for (const std::string& name : names) {
      const auto found = index_.find(name);
      if (found == index_.end()) return "the scene has no robot " + quoted(name);
      if (last_naming_[found->second] == naming_) return "it names " + quoted(name) + " twice";
      last_naming_[found->second] = naming_;
    }
    if (last_naming_[index_.at(self)] != naming_) return "it does not name the robot itself";
    return std::nullopt;
  }

 private:
  std::unordered_map<std::string_view, std::size_t> index_;
  std::vector<std::size_t> last_naming_;  // by robot: the last call of check() that saw its name
  std::size_t naming_ = 0;
};

std::optional<Violation> check_times(const RobotPlan& robot) {
  double end = 0;
  for (std::size_t i = 0; i < robot.segments.size(); ++i) {
    const PlanSegment& segment = robot.segments[i];
    if (!same_time(segment.from, end)) {
      const std::string due =
          i == 0 ? ", not at t = 0" : "; the one before it ends at " + seconds(end);
      return malformed(robot, i, "it begins at " + seconds(segment.from) + due);
    }
    // One of a robot that never moves has no length.
    if (!(segment.to >= segment.from)) {
      const std::string begin = ", before it begins at " + seconds(segment.from);
      return malformed(robot, i, "it ends at " + seconds(segment.to) + begin);
    }
    end = segment.to;
  }
  const double last = robot.trajectory.end_time();
  if (same_time(end, last)) return std::nullopt;
  const std::string due = "; the last waypoint is at " + seconds(last);
  return malformed(robot, robot.segments.size() - 1, "the last ends at " + seconds(end) + due);
}

}  // namespace

std::optional<Violation> check_segments(const Scene& scene, const Plan& plan) {
  Names names(scene);
  for (const RobotPlan& robot : plan.robots) {
    if (robot.segments.empty()) continue;
    if (auto violation = check_times(robot)) return violation;
    for (std::size_t i = 0; i < robot.segments.size(); ++i) {
      if (const auto wrong = names.check(robot.name, robot.segments[i].robots)) {
        return malformed(robot, i, *wrong);
      }
    }
  }
  return std::nullopt;
}

}  // namespace accord::verification
