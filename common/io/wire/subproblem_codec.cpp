#include "common/io/wire/subproblem_codec.h"

#include <optional>

#include "accord.pb.h"
#include "common/io/request_names.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/trajectory_parts.h"
#include "common/planning/region.h"

namespace accord {
namespace {

// ---- To bytes. Structured bindings, so that a field that is added cannot be forgotten here. ----

void put(const Task& task, payload::Task& out) {
  const auto& [robot, version, start, to, goal, region, guide, tail, roadmap_level] = task;
  out.set_robot(robot.value);
  out.set_version(version);
  put_numbers(start, *out.mutable_start());
  out.set_to(to);
  put_numbers(goal, *out.mutable_goal());
  put_numbers(region.lower, *out.mutable_lower());
  put_numbers(region.upper, *out.mutable_upper());
  put_trajectory(guide, *out.mutable_guide());
  put_trajectory(tail, *out.mutable_tail());
  out.set_roadmap_levels(static_cast<std::uint32_t>(roadmap_level + 1));
}

void put(const Outsider& outsider, payload::Outsider& out) {
  const auto& [robot, version, path, until] = outsider;
  out.set_robot(robot.value);
  out.set_version(version);
  put_trajectory(path, *out.mutable_path());
  out.set_until(until);
}

void put(const SolverLimits& limits, payload::SolverLimits& out) {
  const auto& [expansions, checks, orders, samples, nodes, window, last_factor] = limits;
  out.set_query_expansions(expansions);
  out.set_query_checks(checks);
  out.set_priority_orders(orders);
  out.set_decoupled_samples(samples);
  out.set_composite_nodes(nodes);
  out.set_composite_window_per_dof(window);
  out.set_last_factor(last_factor);
}

// ---- From bytes ----

class SubproblemDecoder {
 public:
  explicit SubproblemDecoder(const Scene& scene) : scene_(scene) {}

  std::optional<std::string> fault() const { return inspector_.fault(); }

  bool take(const payload::Subproblem& from, Subproblem& out) {
    out.seed = from.seed();
    out.from = from.from();
    out.to = from.to();
    out.horizon = from.horizon();
    out.clear_until = from.clear_until();
    out.lockstep = from.lockstep();
    out.whole = from.whole();
    const Range later{out.from, limits::kPlanTime, "s"};
    return inspector_.number(out.from, kTimeRange, PayloadPath("from")) &&
           inspector_.number(out.to, later, PayloadPath("to")) &&
           inspector_.number_or_infinity(out.horizon, later, PayloadPath("horizon")) &&
           inspector_.number_or_infinity(out.clear_until, later, PayloadPath("clear_until")) &&
           take_limits(from.limits(), out.limits) && take_tasks(from, out) &&
           take_outsiders(from, out) && (!out.lockstep || can_move_in_lockstep(out));
  }

 private:
  const RobotModel& model(RobotId robot) const { return *scene_.robot(robot).model; }

  bool take_limits(const payload::SolverLimits& from, SolverLimits& out) {
    const PayloadPath limits("limits");
    const auto most = SolverLimits::unlimited().query_expansions;
    const auto one = [&](std::uint64_t value, std::uint64_t least, std::string_view name,
                         std::size_t& limit) {
      limit = value;
      return inspector_.count(value, least, most, "", PayloadPath(limits, name));
    };
    return one(from.query_expansions(), 0, "query_expansions", out.query_expansions) &&
           one(from.query_checks(), 0, "query_checks", out.query_checks) &&
           one(from.priority_orders(), 1, "priority_orders", out.priority_orders) &&
           one(from.decoupled_samples(), 0, "decoupled_samples", out.decoupled_samples) &&
           one(from.composite_nodes(), 0, "composite_nodes", out.composite_nodes) &&
           one(from.composite_window_per_dof(), 1, "composite_window_per_dof",
               out.composite_window_per_dof) &&
           one(from.last_factor(), 1, "last_factor", out.last_factor);
  }

  // The scene's, and after the one before: nobody is named twice.
  bool take_robot(std::uint64_t value, std::optional<RobotId> before, const PayloadPath& at,
                  RobotId& out) {
    if (!inspector_.index(value, scene_.robots.size(), "robot", at)) return false;
    out = RobotId{static_cast<std::uint32_t>(value)};
    return !before || out > *before || inspector_.fail(at, "expected robots in ascending order");
  }

  bool take_tasks(const payload::Subproblem& from, Subproblem& out) {
    const auto size = static_cast<std::size_t>(from.tasks_size());
    if (!inspector_.count(size, 1, scene_.robots.size(), "", PayloadPath("tasks"))) return false;
    out.tasks.resize(size);
    // A robot that is planned for alone has no path yet.
    const bool first_path = size == 1 && from.outsiders_size() == 0;
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at("tasks", i);
      const auto before = i > 0 ? std::optional(out.tasks[i - 1].robot) : std::nullopt;
      if (!take(from.tasks(static_cast<int>(i)), out.from, before, first_path, at, out.tasks[i])) {
        return false;
      }
    }
    return true;
  }

  bool take(const payload::Task& from, double window_start, std::optional<RobotId> before,
            bool first_path, const PayloadPath& at, Task& out) {
    if (!take_robot(from.robot(), before, PayloadPath(at, "robot"), out.robot)) return false;
    out.version = from.version();
    out.to = from.to();
    const std::size_t dof = model(out.robot).dof();
    const PayloadPath guide(at, "guide");
    const PayloadPath tail(at, "tail");
    if (!inspector_.number(out.to, {window_start, limits::kPlanTime, "s"}, PayloadPath(at, "to")) ||
        !inspector_.numbers(from.start(), dof, kConfigurationRange, PayloadPath(at, "start")) ||
        !inspector_.numbers(from.goal(), dof, kConfigurationRange, PayloadPath(at, "goal")) ||
        !take_region(from, out.robot, at, out.region) ||
        !take_trajectory(from.guide(), dof, guide, inspector_, out.guide) ||
        !take_trajectory(from.tail(), dof, tail, inspector_, out.tail) ||
        !inspector_.count(from.roadmap_levels(), 0, kRoadmapLevels, "",
                          PayloadPath(at, "roadmap_levels"))) {
      return false;
    }
    out.roadmap_level = static_cast<int>(from.roadmap_levels()) - 1;
    out.start = take_numbers(from.start());
    out.goal = take_numbers(from.goal());
    if (out.guide.empty() && !first_path) return inspector_.fail(guide, "expected a path");
    if (out.tail.empty() && !first_path) return inspector_.fail(tail, "expected a path");
    return true;
  }

  bool take_region(const payload::Task& from, RobotId robot, const PayloadPath& at, Region& out) {
    const std::size_t dof = model(robot).dof();
    const PayloadPath lower(at, "lower");
    const PayloadPath upper(at, "upper");
    if (!inspector_.numbers(from.lower(), dof, kConfigurationRange, lower) ||
        !inspector_.numbers(from.upper(), dof, kConfigurationRange, upper)) {
      return false;
    }
    out = {take_numbers(from.lower()), take_numbers(from.upper())};
    const Region whole = whole_region(scene_, robot);
    for (std::size_t k = 0; k < dof; ++k) {
      const bool wraps = model(robot).dofs[k].wraps;
      const Range most = wraps ? kConfigurationRange : Range{whole.lower[k], whole.upper[k], ""};
      if (!inspector_.number(out.lower[k], most, PayloadPath(lower, "", k)) ||
          !inspector_.number(out.upper[k], {out.lower[k], most.max, ""},
                             PayloadPath(upper, "", k))) {
        return false;
      }
    }
    return true;
  }

  bool take_outsiders(const payload::Subproblem& from, Subproblem& out) {
    const auto size = static_cast<std::size_t>(from.outsiders_size());
    if (!inspector_.count(size, 0, scene_.robots.size(), "", PayloadPath("outsiders"))) {
      return false;
    }
    out.outsiders.resize(size);
    std::size_t task = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at("outsiders", i);
      const auto before = i > 0 ? std::optional(out.outsiders[i - 1].robot) : std::nullopt;
      const payload::Outsider& one = from.outsiders(static_cast<int>(i));
      Outsider& outsider = out.outsiders[i];
      if (!take_robot(one.robot(), before, PayloadPath(at, "robot"), outsider.robot)) return false;
      while (task < out.tasks.size() && out.tasks[task].robot < outsider.robot) ++task;
      if (task < out.tasks.size() && out.tasks[task].robot == outsider.robot) {
        return inspector_.fail(PayloadPath(at, "robot"), "the robot has a task");
      }
      outsider.version = one.version();
      outsider.until = one.until();
      const PayloadPath path(at, "path");
      if (!inspector_.number_or_infinity(outsider.until, {0, limits::kPlanTime, "s"},
                                         PayloadPath(at, "until")) ||
          !take_trajectory(one.path(), model(outsider.robot).dof(), path, inspector_,
                           outsider.path)) {
        return false;
      }
      if (outsider.path.empty()) return inspector_.fail(path, "expected a path");
    }
    return true;
  }

  bool can_move_in_lockstep(const Subproblem& subproblem) {
    const RobotKind kind = model(subproblem.tasks.front().robot).kind;
    for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
      const RobotKind own = model(subproblem.tasks[i].robot).kind;
      if (own == kind && (own == RobotKind::kDisk || own == RobotKind::kBall)) continue;
      return inspector_.fail(PayloadPath("tasks", i),
                             "only discs, or only balls, move in lockstep");
    }
    return true;
  }

  const Scene& scene_;
  Inspector inspector_;
};

}  // namespace

Bytes encode_subproblem(const Subproblem& subproblem) {
  const auto& [seed, from, to, horizon, clear_until, lockstep, whole, tasks, outsiders, limits] =
      subproblem;
  payload::Subproblem out;
  out.set_seed(seed);
  out.set_from(from);
  out.set_to(to);
  out.set_horizon(horizon);
  out.set_clear_until(clear_until);
  out.set_lockstep(lockstep);
  out.set_whole(whole);
  for (const Task& task : tasks) put(task, *out.add_tasks());
  for (const Outsider& outsider : outsiders) put(outsider, *out.add_outsiders());
  put(limits, *out.mutable_limits());
  return serialize_payload(out);
}

tl::expected<Subproblem, std::string> decode_subproblem(BytesView bytes, const Scene& scene) {
  payload::Subproblem message;
  const ScanLimits limits{limits::kSubproblemBytes, 8 * scene.robots.size() + 8};
  if (auto fault = parse_payload(bytes, "a subproblem", limits, message)) {
    return tl::unexpected(std::move(*fault));
  }
  Subproblem out;
  SubproblemDecoder decoder(scene);
  if (!decoder.take(message, out)) return tl::unexpected(*decoder.fault());
  return out;
}

Bytes encode_hierarchy(const std::vector<std::string>& solvers, const std::string& request) {
  payload::Hierarchy out;
  for (const std::string& solver : solvers) out.add_solvers(solver);
  out.set_request(request);
  return serialize_payload(out);
}

tl::expected<Hierarchy, std::string> decode_hierarchy(BytesView bytes) {
  payload::Hierarchy message;
  const ScanLimits limits{
      limits::kSolvers * (limits::kSolverNameBytes + 8) + limits::kRequestIdBytes + 8,
      limits::kSolvers + 1};
  if (auto fault = parse_payload(bytes, "a hierarchy", limits, message)) {
    return tl::unexpected(std::move(*fault));
  }
  Inspector inspector;
  Hierarchy out{{message.solvers().begin(), message.solvers().end()}, message.request()};
  inspector.count(out.solvers.size(), 1, limits::kSolvers, "names", PayloadPath("solvers"));
  for (std::size_t i = 0; i < out.solvers.size(); ++i) {
    inspector.name(out.solvers[i], PayloadPath("solvers", i), limits::kSolverNameBytes);
  }
  if (!out.request.empty() && !is_request_id(out.request)) {
    inspector.fail(PayloadPath("request"), "expected " + std::string(kRequestIdInWords));
  }
  if (inspector.fault()) return tl::unexpected(*inspector.fault());
  return out;
}

}  // namespace accord
