#include "common/io/query_checks.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <string>

#include "common/geometry/collision_world.h"
#include "common/io/robots.h"
#include "common/io/words.h"

namespace accord {
namespace {

std::string metres(double value) {
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%.3g m", value);
  return out.data();
}

// The start or the goal of all robots.
struct Side {
  QuerySide name;
  std::string_view word;
  Configuration Robot::*configuration;
  QueryCheck QueryChecks::*check;
};

constexpr std::array kSides = {Side{QuerySide::kStart, "start", &Robot::start, &QueryChecks::start},
                               Side{QuerySide::kGoal, "goal", &Robot::goal, &QueryChecks::goal}};

class QueryChecker {
 public:
  QueryChecker(std::shared_ptr<const Scene> scene, const std::vector<QueryChecks>& checks,
               const QueryBlame& blame)
      : scene_(*scene), world_(std::move(scene), kQueryMargin), checks_(checks), blame_(blame) {}

  void check(const Side& side) {
    std::vector<RobotId> robots;
    for (std::uint32_t i = 0; i < scene_.robots.size(); ++i) {
      if (checks_[i].*side.check != QueryCheck::kNone) robots.push_back(RobotId{i});
    }
    for (const RobotId id : robots) {
      if (ended_) return;
      if (is_due(side, id)) check_alone(side, id);
    }
    check_pairs(side, robots);
  }

 private:
  const Configuration& configuration(const Side& side, RobotId id) const {
    return scene_.robot(id).*side.configuration;
  }

  bool is_due(const Side& side, RobotId id) const {
    return checks_[id.index()].*side.check == QueryCheck::kDue;
  }

  void report(const Side& side, RobotId id, const std::string& text) {
    const bool arm = scene_.robot(id).model->kind == RobotKind::kArm;
    const std::string word(side.word);
    const bool go_on = blame_(
        id, side.name,
        text + (arm ? "; choose another " + word : "; move the " + word + " or shrink the robot"));
    ended_ = ended_ || !go_on;
  }

  std::string robot_in_words(RobotId id) const {
    const Robot& robot = scene_.robot(id);
    return std::string(kind_in_words(robot.model->kind)) + " " + in_quotes(robot.name);
  }

  // As robot_in_words(), with the body where there are several.
  std::string body_in_words(RobotId id, const std::string& body) const {
    const bool arm = scene_.robot(id).model->kind == RobotKind::kArm;
    return robot_in_words(id) + (arm ? " (link " + in_quotes(body) + ")" : "");
  }

  // "would overlap X by 0.1 m", or that it is too close.
  std::string contact_in_words(const std::string& other, double gap, double clearance) const {
    if (gap < -kQueryMargin) return " would overlap " + other + " by " + metres(-gap);
    if (clearance == 0 || gap <= kQueryMargin) return " would touch " + other;
    return " would be " + metres(gap) + " from " + other + ", within the clearance of " +
           metres(clearance);
  }

  // Obstacles without a name of their own are named after their place in the file: "obstacle 3
  // (box)".
  static std::string obstacle_in_words(const std::string& name) {
    return name.starts_with("obstacle ") ? name : "obstacle " + in_quotes(name);
  }

  std::string escape_in_words(const Aabb& box) const {
    const Vec3 excess = (scene_.bounds->min - box.min).cwiseMax(box.max - scene_.bounds->max);
    const double worst = scene_.planar ? excess.head<2>().maxCoeff() : excess.maxCoeff();
    if (worst < kQueryMargin) return " would touch the bounds";
    return " would leave the bounds by " + metres(worst);
  }

  void check_alone(const Side& side, RobotId id) {
    const Configuration& q = configuration(side, id);
    const auto fault = world_.fault(id, q);
    if (!fault) return;
    const std::string body = body_in_words(id, fault->body);
    switch (fault->kind) {
      case Fault::Kind::kBounds:
        return report(side, id, body + escape_in_words(world_.swept_bounds(id, q, q)));
      case Fault::Kind::kObstacle:
        return report(
            side, id,
            body + contact_in_words(obstacle_in_words(fault->other), fault->gap, scene_.clearance));
      case Fault::Kind::kSelf:
        return report(
            side, id,
            body + contact_in_words("its own link " + in_quotes(fault->other), fault->gap, 0));
      case Fault::Kind::kLimit:
      case Fault::Kind::kRobot:
        return report(side, id, body + " is beyond the limit of " + in_quotes(fault->body));
    }
  }

  // Sort and sweep along the axis on which the robots are spread widest.
  void check_pairs(const Side& side, const std::vector<RobotId>& robots) {
    std::vector<Aabb> boxes;
    for (const RobotId id : robots) {
      const Configuration& q = configuration(side, id);
      boxes.push_back(world_.swept_bounds(id, q, q));
      boxes.back().max.array() += world_.required_separation();
    }
    const Eigen::Index axis = widest_axis(boxes);
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::size_t i) { return boxes[i].min[axis]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (boxes[order[j]].min[axis] > boxes[order[i]].max[axis]) break;
        if (!boxes[order[i]].overlaps(boxes[order[j]])) continue;
        if (ended_) return;
        check_pair(side, robots[std::min(order[i], order[j])],
                   robots[std::max(order[i], order[j])]);
      }
    }
  }

  static Eigen::Index widest_axis(const std::vector<Aabb>& boxes) {
    if (boxes.empty()) return 0;
    Aabb all = boxes.front();
    for (const Aabb& box : boxes) all.merge(box);
    Eigen::Index axis = 0;
    (all.max - all.min).maxCoeff(&axis);
    return axis;
  }

  void check_pair(const Side& side, RobotId first, RobotId second) {
    if (!is_due(side, first) && !is_due(side, second)) return;
    // The later robot is to blame, as one reads from the top, unless it has passed.
    if (!is_due(side, second)) std::swap(first, second);
    const Configuration& a = configuration(side, first);
    const Configuration& b = configuration(side, second);
    if (world_.are_clear(first, a, second, b)) return;
    const Fault fault = world_.closest(second, b, first, a);
    report(side, second,
           robot_in_words(second) +
               contact_in_words(robot_in_words(first) + " at its " + std::string(side.word),
                                fault.gap, scene_.clearance));
  }

  const Scene& scene_;
  CollisionWorld world_;
  const std::vector<QueryChecks>& checks_;
  const QueryBlame& blame_;
  bool ended_ = false;
};

}  // namespace

void check_queries(std::shared_ptr<const Scene> scene, const std::vector<QueryChecks>& checks,
                   const QueryBlame& blame) {
  QueryChecker checker(std::move(scene), checks, blame);
  for (const Side& side : kSides) checker.check(side);
}

}  // namespace accord
