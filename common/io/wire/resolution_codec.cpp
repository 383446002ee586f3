#include "common/io/wire/resolution_codec.h"

#include <algorithm>

#include "accord.pb.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/trajectory_parts.h"

namespace accord {
namespace {

void put(const Effort& effort, payload::Effort& out) {
  const auto& [searches, expansions, samples, motion_checks, distance_queries] = effort;
  out.set_searches(searches);
  out.set_expansions(expansions);
  out.set_samples(samples);
  out.set_motion_checks(motion_checks);
  out.set_distance_queries(distance_queries);
}

bool take_paths(const payload::Resolution& from, const Scene& scene, const Subproblem& subproblem,
                Inspector& inspector, Resolution& out) {
  const auto size = static_cast<std::size_t>(from.paths_size());
  const std::size_t tasks = subproblem.tasks.size();
  const bool may_be_none = !out.solved && from.left_size() == 0;
  if (!(size == 0 && may_be_none) &&
      !inspector.count(size, tasks, tasks, "", PayloadPath("paths"))) {
    return false;
  }
  out.paths.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    const PayloadPath at("paths", i);
    const std::size_t dof = scene.robot(subproblem.tasks[i].robot).model->dof();
    if (!take_trajectory(from.paths(static_cast<int>(i)), dof, at, inspector, out.paths[i])) {
      return false;
    }
    if (out.paths[i].empty() && !may_be_none) return inspector.fail(at, "expected a path");
  }
  return true;
}

// In any order: solvers list them as they were given up.
bool take_left(const payload::Resolution& from, const Subproblem& subproblem, Inspector& inspector,
               Resolution& out) {
  std::vector<RobotId> may_be_left;
  for (const Task& task : subproblem.tasks) may_be_left.push_back(task.robot);
  std::vector<bool> named(may_be_left.size(), false);
  for (int i = 0; i < from.left_size(); ++i) {
    const RobotId robot{from.left(i)};
    const auto found = std::ranges::lower_bound(may_be_left, robot);
    const auto task = static_cast<std::size_t>(found - may_be_left.begin());
    if (found == may_be_left.end() || *found != robot || named[task]) {
      return inspector.fail(PayloadPath("left", static_cast<std::size_t>(i)),
                            "expected robots that have tasks, each once");
    }
    named[task] = true;
    out.left.push_back(robot);
  }
  return true;
}

}  // namespace

Bytes encode_resolution(const Resolution& resolution) {
  const auto& [solved, solver, roadmap_level, end, paths, left, effort] = resolution;
  payload::Resolution out;
  out.set_solved(solved);
  out.set_solver(solver);
  out.set_roadmap_levels(static_cast<std::uint32_t>(roadmap_level + 1));
  out.set_end(end);
  for (const Trajectory& path : paths) put_trajectory(path, *out.add_paths());
  for (const RobotId robot : left) out.add_left(robot.value);
  put(effort, *out.mutable_effort());
  return serialize_payload(out);
}

tl::expected<Resolution, std::string> decode_resolution(BytesView bytes, const Scene& scene,
                                                        const Subproblem& subproblem) {
  payload::Resolution message;
  const ScanLimits limits{limits::kResolutionBytes, subproblem.tasks.size() + 4};
  if (auto fault = parse_payload(bytes, "a resolution", limits, message)) {
    return tl::unexpected(std::move(*fault));
  }
  Resolution out;
  out.solved = message.solved();
  out.solver = message.solver();
  out.end = message.end();
  out.effort = {message.effort().searches(), message.effort().expansions(),
                message.effort().samples(), message.effort().motion_checks(),
                message.effort().distance_queries()};
  Inspector inspector;
  const PayloadPath solver("solver");
  const bool sound =
      (out.solver.empty() || inspector.name(out.solver, solver, limits::kSolverNameBytes)) &&
      (!out.solved || !out.solver.empty() || inspector.fail(solver, "expected a name")) &&
      inspector.count(message.roadmap_levels(), 0, kRoadmapLevels, "",
                      PayloadPath("roadmap_levels")) &&
      inspector.number(out.end, kTimeRange, PayloadPath("end")) &&
      take_paths(message, scene, subproblem, inspector, out) &&
      take_left(message, subproblem, inspector, out);
  if (!sound) return tl::unexpected(*inspector.fault());
  out.roadmap_level = static_cast<int>(message.roadmap_levels()) - 1;
  return out;
}

}  // namespace accord
