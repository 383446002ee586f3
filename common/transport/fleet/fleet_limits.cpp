#include "common/transport/fleet/fleet_limits.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string_view>
#include <unordered_set>

namespace accord {
namespace {

using Fault = std::optional<std::string>;

Fault at_most(std::size_t value, std::size_t most, std::string_view of_what) {
  if (value <= most) return std::nullopt;
  return std::to_string(value) + " " + std::string(of_what) + "; expected at most " +
         std::to_string(most);
}

Fault first_of(std::initializer_list<Fault> faults) {
  for (const Fault& fault : faults) {
    if (fault) return fault;
  }
  return std::nullopt;
}

// On the wire a string ends at its first zero byte.
Fault string_fault(std::string_view text, std::size_t most, std::string_view of_what) {
  if (text.find('\0') != std::string_view::npos) {
    return "a zero byte among the " + std::string(of_what);
  }
  return at_most(text.size(), most, of_what);
}
Fault id_fault(const std::string& id) {
  return string_fault(id, kFleetIdBytes, "bytes of a request's id");
}
Fault name_fault(const std::string& name, std::string_view of_what) {
  return string_fault(name, kFleetNameBytes, of_what);
}
Fault text_fault(const std::string& text) {
  return string_fault(text, kFleetTextBytes, "bytes of text");
}

bool all_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

// ---- Requests ----

Fault attachments_fault(const std::vector<PlanRequest::Attachment>& attachments) {
  if (auto fault = at_most(attachments.size(), kAttachments, "attachments")) return fault;
  std::size_t bytes = 0;
  for (const auto& [name, content] : attachments) {
    if (auto fault = name_fault(name, "bytes of an attachment's name")) return fault;
    bytes += content.size();
  }
  return at_most(bytes, kAttachmentBytes, "bytes of attachments");
}

Fault queries_fault(const std::vector<PlanRequest::Query>& queries) {
  if (auto fault = at_most(queries.size(), limits::kRobots, "queries")) return fault;
  for (const auto& [robot, start, goal] : queries) {
    if (auto fault = name_fault(robot, "bytes of a robot's name")) return fault;
    for (const auto& end : {&start, &goal}) {
      if (!*end) continue;
      if (auto fault = at_most((*end)->size(), limits::kLinks, "numbers of a configuration")) {
        return fault;
      }
    }
  }
  return std::nullopt;
}

Fault solvers_fault(const std::vector<std::string>& solvers) {
  if (auto fault = at_most(solvers.size(), limits::kSolvers, "solvers")) return fault;
  for (const std::string& solver : solvers) {
    if (auto fault = name_fault(solver, "bytes of a solver's name")) return fault;
  }
  return std::nullopt;
}

Fault fault_of(const PlanRequest& request) {
  return first_of(
      {id_fault(request.id),
       string_fault(request.scene_text, limits::kSceneBytes, "bytes of a scene"),
       attachments_fault(request.attachments),
       name_fault(request.scene_name, "bytes of a scene's name"), queries_fault(request.queries),
       name_fault(request.method, "bytes of a method's name"), solvers_fault(request.solvers)});
}
Fault fault_of(const CancelRequest& request) {
  return id_fault(request.id);
}
Fault fault_of(const ResendRequest& request) {
  return id_fault(request.id);
}

// ---- News ----

// Of whatever reason: a newer service may have some that are not known here.
Fault fault_of(const RequestReply& reply) {
  return first_of({id_fault(reply.id), text_fault(reply.field), text_fault(reply.text)});
}
Fault fault_of(const RequestState& state) {
  if (state.phase > RequestPhase::kFinished) return "a state of an unknown phase";
  if (!(state.per_cent >= 0 && state.per_cent <= 100)) return "a state beyond 0 to 100 per cent";
  if (!std::isfinite(state.elapsed) || !std::isfinite(state.best_cost)) {
    return "a state with a number that is not finite";
  }
  return id_fault(state.id);
}
Fault fault_of(const WorkerStatus& worker) {
  return first_of({name_fault(worker.host, "bytes of a host's name"),
                   name_fault(worker.version, "bytes of a version"),
                   name_fault(worker.standing, "bytes of a standing"), text_fault(worker.text)});
}
Fault fault_of(const ServiceStatus& service) {
  return first_of({name_fault(service.host, "bytes of a host's name"),
                   name_fault(service.version, "bytes of a version")});
}

// ---- Plans ----

Fault outline_fault(const std::string& id, const Plan& plan) {
  if (plan.status > PlanStatus::kInvalid) return "a plan of an unknown status";
  for (const RobotPlan& robot : plan.robots) {
    if (auto fault = name_fault(robot.name, "bytes of a robot's name")) return fault;
  }
  for (const auto& [name, value] : plan.statistics) {
    if (auto fault = name_fault(name, "bytes of a statistic's name")) return fault;
  }
  return first_of({id_fault(id), name_fault(plan.scene, "bytes of a scene's name"),
                   text_fault(plan.message), name_fault(plan.method, "bytes of a method's name"),
                   at_most(plan.statistics.size(), kStatistics, "statistics"),
                   at_most(plan.robots.size(), limits::kRobots, "robots")});
}
Fault fault_of(const PlanOutline& outline) {
  return first_of({outline_fault(outline.id, outline.plan),
                   name_fault(outline.content, "bytes of a content's hash")});
}

Fault segment_fault(const std::string& solver, std::size_t robots) {
  return first_of({string_fault(solver, limits::kSolverNameBytes, "bytes of a solver's name"),
                   at_most(robots, limits::kRobots, "robots of a segment")});
}

Fault fault_of(const PathPiece& piece) {
  if (piece.piece >= piece.pieces) return "a piece beyond the last one";
  if (piece.dof > limits::kLinks || piece.configurations.size() != piece.times.size() * piece.dof) {
    return "a piece whose configurations are of another size";
  }
  if (!all_finite(piece.times) || !all_finite(piece.configurations)) {
    return "a piece with a number that is not finite";
  }
  for (const PathSegment& segment : piece.segments) {
    if (auto fault = segment_fault(segment.solver, segment.robots.size())) return fault;
  }
  return first_of({id_fault(piece.id), name_fault(piece.robot, "bytes of a robot's name"),
                   at_most(piece.robot_index, limits::kRobots - 1, "robots before a robot"),
                   at_most(piece.pieces, kPathPieces, "pieces of a path"),
                   at_most(content_bytes(piece), kPathPieceBytes, "bytes of a piece")});
}

Fault path_fault(const RobotPlan& robot, const std::unordered_set<std::string_view>& names) {
  const Trajectory& path = robot.trajectory;
  if (auto fault = at_most(path.dof(), limits::kLinks, "numbers of a configuration")) return fault;
  bool finite = all_finite(path.times());
  for (std::size_t i = 0; i < path.size(); ++i)
    finite = finite && all_finite(path.configuration(i));
  if (!finite) return "a path with a number that is not finite";
  for (const PlanSegment& segment : robot.segments) {
    if (auto fault = segment_fault(segment.solver, segment.robots.size())) return fault;
    for (const std::string& name : segment.robots) {
      if (!names.contains(name)) return "a segment with a robot that the plan does not have";
    }
  }
  return std::nullopt;
}

Fault fault_of(const FinishedPlan& finished) {
  const auto& [id, plan, scene, content] = finished;
  if (auto fault = outline_fault(id, plan)) return fault;
  if (auto fault = name_fault(content, "bytes of a content's hash")) return fault;
  std::unordered_set<std::string_view> names;
  for (const RobotPlan& robot : plan.robots) names.insert(robot.name);
  std::size_t bytes = 0;
  for (const RobotPlan& robot : plan.robots) {
    if (auto fault = path_fault(robot, names)) return fault;
    bytes += robot.trajectory.size() * waypoint_bytes(robot.trajectory.dof());
    for (const PlanSegment& segment : robot.segments) {
      bytes += segment_bytes(segment.solver.size(), segment.robots.size());
    }
  }
  return at_most(bytes, kPlanWireBytes, "bytes of a plan");
}

}  // namespace

std::optional<std::string> fleet_fault(const FleetRequest& request) {
  return std::visit([](const auto& kind) { return fault_of(kind); }, request);
}
std::optional<std::string> fleet_fault(const FleetNews& news) {
  return std::visit([](const auto& kind) { return fault_of(kind); }, news);
}
std::optional<std::string> fleet_fault(const FleetPart& part) {
  return std::visit([](const auto& kind) { return fault_of(kind); }, part);
}

std::size_t waypoint_bytes(std::size_t dof) {
  return sizeof(double) * (1 + dof);
}

std::size_t segment_bytes(std::size_t solver_bytes, std::size_t robots) {
  return kSegmentHeadBytes + solver_bytes + sizeof(std::uint32_t) * robots;
}

std::size_t content_bytes(const PathPiece& piece) {
  std::size_t bytes = piece.times.size() * waypoint_bytes(piece.dof);
  for (const PathSegment& segment : piece.segments) {
    bytes += segment_bytes(segment.solver.size(), segment.robots.size());
  }
  return bytes;
}

std::size_t memory_of(const FinishedPlan& finished) {
  std::size_t bytes = 0;
  for (const RobotPlan& robot : finished.plan.robots) {
    bytes += robot.trajectory.size() * waypoint_bytes(robot.trajectory.dof());
    for (const PlanSegment& segment : robot.segments) {
      bytes += sizeof(segment) + segment.robots.size() * sizeof(std::string);
    }
  }
  return bytes;
}

}  // namespace accord
