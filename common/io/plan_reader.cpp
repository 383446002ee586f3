#include <array>
#include <utility>

#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/json_reader.h"
#include "common/io/limits.h"
#include "common/io/plan_file.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::string_view kVersion = "plan/1";
constexpr Range kAnyTime{-limits::kPlanTime, limits::kPlanTime, "s"};
constexpr Range kTime{0, limits::kPlanTime, "s"};
constexpr Range kStep{limits::kMinTimestep, limits::kTimestep, "s"};
constexpr Range kAnyNumber{-1e12, 1e12, ""};

class PlanReader {
 public:
  explicit PlanReader(Faults& faults) : faults_(faults) {}

  Plan read(const Value& root) {
    Plan plan;
    if (!expect_map(root, "a plan: an object of keys", faults_)) return plan;
    const Fields fields(
        root, "a plan",
        {"accord", "scene", "status", "message", "method", "seed", "timestep", "planning_time",
         "makespan", "sum_of_costs", "sum_of_costs_timesteps", "robots", "statistics"},
        faults_);
    if (const auto value = fields.require("accord", kVersion); value && value->text() != kVersion) {
      fault_at(*value, "expected " + std::string(kVersion) + ", not " + value->in_words(), faults_);
      return plan;
    }
    plan.scene = text(fields, "scene");
    plan.status = status(fields);
    plan.message = text(fields, "message");
    plan.method = text(fields, "method");
    if (const auto value = fields.require("seed", "a whole number")) {
      plan.seed = read_count(*value, faults_).value_or(0);
    }
    plan.timestep = number(fields, "timestep", kStep);
    plan.planning_time = number(fields, "planning_time", kTime);
    plan.makespan = number(fields, "makespan", kTime);
    plan.sum_of_costs = number(fields, "sum_of_costs", kAnyNumber);
    if (const auto value = fields.require("sum_of_costs_timesteps", "a whole number")) {
      plan.sum_of_costs_timesteps =
          static_cast<std::int64_t>(read_count(*value, faults_).value_or(0) & INT64_MAX);
    }
    read_robots(fields, plan);
    read_statistics(fields, plan);
    return plan;
  }

 private:
  // A string in quotes, which may be empty.
  std::string text(const Fields& fields, std::string_view key) {
    const auto value = fields.require(key, "a string");
    if (!value) return "";
    if (value->kind() != ValueKind::kQuoted) {
      fault_at(*value, "expected a string, not " + value->in_words(), faults_);
    }
    return std::string(value->text());
  }

  double number(const Fields& fields, std::string_view key, Range range) {
    const auto value = fields.require(key, "a number");
    return value ? read_number(*value, range, faults_).value_or(range.max) : range.max;
  }

  PlanStatus status(const Fields& fields) {
    constexpr std::array kAll = {PlanStatus::kSolved, PlanStatus::kInfeasible, PlanStatus::kTimeout,
                                 PlanStatus::kCancelled, PlanStatus::kInvalid};
    const auto value = fields.require("status", "a string");
    if (!value) return PlanStatus::kInvalid;
    std::vector<std::string_view> words;
    for (const PlanStatus status : kAll) {
      if (value->text() == to_string(status)) return status;
      words.push_back(to_string(status));
    }
    fault_at(*value, "expected " + alternatives(words) + ", not " + value->in_words(), faults_);
    return PlanStatus::kInvalid;
  }

  void read_robots(const Fields& fields, Plan& plan) {
    const auto list = fields.require("robots", "a list of robots");
    if (!list || !expect_list(*list, "robots", faults_)) return;
    if (list->size() > limits::kRobots) {
      return fault_at(*list, "more than " + std::to_string(limits::kRobots) + " robots", faults_);
    }
    for (const Value value : *list) {
      if (faults_.full()) return;
      if (!expect_map(value, "a robot's plan", faults_)) continue;
      const Fields robot(value, "a robot's plan", {"name", "waypoints", "segments"}, faults_);
      RobotPlan out;
      if (const auto name = robot.require("name", "a string")) {
        out.name = read_name(*name, faults_).value_or("");
      }
      if (const auto waypoints = robot.require("waypoints", "a list of waypoints")) {
        out.trajectory = read_waypoints(*waypoints);
      }
      if (const auto segments = robot.require("segments", "a list of segments")) {
        out.segments = read_segments(*segments);
      }
      plan.robots.push_back(std::move(out));
    }
  }

  Trajectory read_waypoints(const Value& list) {
    Trajectory path;
    if (!expect_list(list, "waypoints", faults_)) return path;
    bool sound = true;
    for (const Value value : list) {
      if (faults_.full()) return path;
      sound = read_waypoint(value, path, sound);
    }
    if (sound && path.empty()) fault_at(list, "expected at least one waypoint", faults_);
    return path;
  }

  // Appends to the path unless it or what came before is at fault.
  bool read_waypoint(const Value& value, Trajectory& path, bool sound) {
    if (!expect_map(value, "a waypoint, {\"t\": ..., \"q\": [...]}", faults_)) return false;
    const Fields fields(value, "a waypoint", {"t", "q"}, faults_);
    const auto t_value = fields.require("t", "a time in s");
    const auto q_value = fields.require("q", "a configuration");
    const auto t = t_value ? read_number(*t_value, kAnyTime, faults_) : std::nullopt;
    const auto q = q_value ? read_configuration(*q_value) : std::nullopt;
    if (!sound || !t || !q) return false;
    if (path.empty()) path = Trajectory(q->size());
    if (q->size() != path.dof()) {
      fault_at(*q_value,
               "expected " + std::to_string(path.dof()) +
                   " numbers as in the first waypoint, not " + std::to_string(q->size()),
               faults_);
      return false;
    }
    if (!path.empty() && *t <= path.end_time()) {
      fault_at(*t_value,
               "times must increase, but " + std::string(t_value->text()) + " follows " +
                   in_words(path.end_time()),
               faults_);
      return false;
    }
    path.append(*t, *q);
    return true;
  }

  std::optional<Configuration> read_configuration(const Value& value) {
    if (!expect_list(value, "numbers", faults_)) return std::nullopt;
    Configuration q;
    bool sound = true;
    for (const Value item : value) {
      const auto number = read_number(item, kAnyNumber, faults_);
      sound = sound && number;
      q.push_back(number.value_or(0));
    }
    if (!sound) return std::nullopt;
    return q;
  }

  std::vector<PlanSegment> read_segments(const Value& list) {
    std::vector<PlanSegment> segments;
    if (!expect_list(list, "segments", faults_)) return segments;
    for (const Value value : list) {
      if (faults_.full()) return segments;
      if (!expect_map(value, "a segment", faults_)) continue;
      const Fields fields(value, "a segment", {"from", "to", "robots", "solver"}, faults_);
      const std::size_t before = faults_.count();
      PlanSegment segment{number(fields, "from", kTime), number(fields, "to", kTime),
                          read_names(fields), text(fields, "solver")};
      const auto to = fields.find("to");
      if (faults_.count() == before && to && segment.to < segment.from) {
        fault_at(*to, "ends before it begins, at " + in_words(segment.from), faults_);
      }
      segments.push_back(std::move(segment));
    }
    return segments;
  }

  std::vector<std::string> read_names(const Fields& fields) {
    std::vector<std::string> names;
    const auto list = fields.require("robots", "a list of names");
    if (!list || !expect_list(*list, "names", faults_)) return names;
    for (const Value value : *list) names.push_back(read_name(value, faults_).value_or(""));
    return names;
  }

  void read_statistics(const Fields& fields, Plan& plan) {
    const auto map = fields.find("statistics");
    if (!map || !expect_map(*map, "an object of counts and times", faults_)) return;
    for (auto it = map->begin(); it != map->end(); ++it) {
      const Value key = *it;
      const Value value = *++it;
      const auto number =
          value.kind() == ValueKind::kPlain ? parse_number(value.text()) : std::nullopt;
      if (number) plan.statistics.emplace_back(key.text(), *number);
    }
  }

  Faults& faults_;
};

}  // namespace

PlanResult load_plan(const std::filesystem::path& path) {
  const auto text = read_file(path, limits::kPlanBytes);
  if (!text) return {std::nullopt, {{path.string(), 0, "", text.error()}}};
  return parse_plan(*text, path.string());
}

PlanResult parse_plan(std::string_view text, const std::string& file) {
  Faults faults(file);
  const auto document = read_json(text, file, limits::kPlanNodes, faults);
  std::optional<Plan> plan;
  if (document) plan = PlanReader(faults).read(document->root());
  if (faults.count() > 0) plan.reset();
  return {std::move(plan), faults.take()};
}

}  // namespace accord
