#include "common/transport/dds/fleet/conversions.h"

#include <utility>

namespace accord::dds {
namespace {

std::vector<std::uint8_t> to_octets(const std::string& text) {
  return {text.begin(), text.end()};
}

std::optional<Configuration> end_of_query(bool is_there, std::vector<double>& numbers) {
  if (!is_there) return std::nullopt;
  return std::move(numbers);
}

}  // namespace

// ---- Requests ----

void to_wire(const PlanRequest& request, fleet::PlanRequest& out) {
  const auto& [id, scene_text, attachments, scene_name, queries, method, seed, solvers, deadline,
               priority] = request;
  out.request_id(id);
  out.scene_text(scene_text);
  out.attachments().resize(attachments.size());
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    const auto& [name, content] = attachments[i];
    out.attachments()[i].name(name);
    out.attachments()[i].content(to_octets(content));
  }
  out.scene_name(scene_name);
  out.queries().resize(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto& [robot, start, goal] = queries[i];
    fleet::Query& query = out.queries()[i];
    query.robot(robot);
    query.has_start(start.has_value());
    if (start) query.start(*start);
    query.has_goal(goal.has_value());
    if (goal) query.goal(*goal);
  }
  out.method(method);
  out.seed(seed);
  out.solvers(solvers);
  out.deadline(deadline);
  out.priority(priority);
}

PlanRequest from_wire(fleet::PlanRequest& from) {
  PlanRequest out;
  out.id = std::move(from.request_id());
  out.scene_text = std::move(from.scene_text());
  for (fleet::Attachment& attachment : from.attachments()) {
    const std::vector<std::uint8_t> content = std::move(attachment.content());
    out.attachments.push_back(
        {std::move(attachment.name()), std::string(content.begin(), content.end())});
  }
  out.scene_name = std::move(from.scene_name());
  for (fleet::Query& query : from.queries()) {
    out.queries.push_back({std::move(query.robot()), end_of_query(query.has_start(), query.start()),
                           end_of_query(query.has_goal(), query.goal())});
  }
  out.method = std::move(from.method());
  out.seed = from.seed();
  out.solvers = std::move(from.solvers());
  out.deadline = from.deadline();
  out.priority = from.priority();
  return out;
}

void to_wire(const CancelRequest& request, fleet::Cancel& out) {
  const auto& [id] = request;
  out.request_id(id);
}
CancelRequest from_wire(fleet::Cancel& from) {
  return {std::move(from.request_id())};
}

void to_wire(const ResendRequest& request, fleet::Resend& out) {
  const auto& [id] = request;
  out.request_id(id);
}
ResendRequest from_wire(fleet::Resend& from) {
  return {std::move(from.request_id())};
}

// ---- News ----

void to_wire(const RequestReply& reply, fleet::RequestReply& out) {
  const auto& [id, accepted, reason, field, text] = reply;
  out.request_id(id);
  out.accepted(accepted);
  out.reason(static_cast<std::uint16_t>(reason));
  out.field(field);
  out.text(text);
}

RequestReply from_wire(fleet::RequestReply& from) {
  return {std::move(from.request_id()), from.accepted(), static_cast<Rejection>(from.reason()),
          std::move(from.field()), std::move(from.text())};
}

void to_wire(const RequestState& state, fleet::PlanStatus& out) {
  const auto& [id, phase, ahead, robots, robots_planned, conflicts_found, conflicts_resolved,
               rounds, elapsed, per_cent, best_cost] = state;
  out.request_id(id);
  out.phase(static_cast<std::uint8_t>(phase));
  out.ahead(ahead);
  out.robots(robots);
  out.robots_planned(robots_planned);
  out.conflicts_found(conflicts_found);
  out.conflicts_resolved(conflicts_resolved);
  out.rounds(rounds);
  out.elapsed(elapsed);
  out.per_cent(per_cent);
  out.best_cost(best_cost);
}

RequestState from_wire(fleet::PlanStatus& from) {
  return {std::move(from.request_id()),
          static_cast<RequestPhase>(from.phase()),
          from.ahead(),
          from.robots(),
          from.robots_planned(),
          from.conflicts_found(),
          from.conflicts_resolved(),
          from.rounds(),
          from.elapsed(),
          from.per_cent(),
          from.best_cost()};
}

void to_wire(const WorkerStatus& worker, fleet::WorkerStatus& out) {
  const auto& [id, host, process, version, threads, busy, standing, text] = worker;
  out.worker(id);
  out.host(host);
  out.process(process);
  out.version(version);
  out.threads(threads);
  out.busy(busy);
  out.standing(standing);
  out.text(text);
}

WorkerStatus from_wire(fleet::WorkerStatus& from) {
  return {from.worker(),
          std::move(from.host()),
          from.process(),
          std::move(from.version()),
          from.threads(),
          from.busy(),
          std::move(from.standing()),
          std::move(from.text())};
}

void to_wire(const ServiceStatus& service, fleet::ServiceStatus& out) {
  const auto& [version, host, process, uptime, workers, threads, queued, planning, finished,
               accepting] = service;
  out.version(version);
  out.host(host);
  out.process(process);
  out.uptime(uptime);
  out.workers(workers);
  out.threads(threads);
  out.queued(queued);
  out.planning(planning);
  out.finished(finished);
  out.accepting(accepting);
}

ServiceStatus from_wire(fleet::ServiceStatus& from) {
  return {std::move(from.version()),
          std::move(from.host()),
          from.process(),
          from.uptime(),
          from.workers(),
          from.threads(),
          from.queued(),
          from.planning(),
          from.finished(),
          from.accepting()};
}

// ---- Plans ----

void to_wire(const PlanOutline& outline, fleet::Plan& out) {
  const auto& [id, version, plan, content] = outline;
  const auto& [scene, status, message, method, seed, timestep, planning_time, makespan,
               sum_of_costs, sum_of_costs_timesteps, robots, statistics] = plan;
  out.request_id(id);
  out.content(content);
  out.version(version);
  out.scene(scene);
  out.status(static_cast<std::uint8_t>(status));
  out.message(message);
  out.method(method);
  out.seed(seed);
  out.timestep(timestep);
  out.planning_time(planning_time);
  out.makespan(makespan);
  out.sum_of_costs(sum_of_costs);
  out.sum_of_costs_timesteps(sum_of_costs_timesteps);
  out.statistics().resize(statistics.size());
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    out.statistics()[i].name(statistics[i].first);
    out.statistics()[i].value(statistics[i].second);
  }
  for (const RobotPlan& robot : robots) out.robots().push_back(robot.name);
}

PlanOutline from_wire(fleet::Plan& from) {
  PlanOutline out{std::move(from.request_id()), from.version(), {}, std::move(from.content())};
  out.plan.scene = std::move(from.scene());
  out.plan.status = static_cast<PlanStatus>(from.status());
  out.plan.message = std::move(from.message());
  out.plan.method = std::move(from.method());
  out.plan.seed = from.seed();
  out.plan.timestep = from.timestep();
  out.plan.planning_time = from.planning_time();
  out.plan.makespan = from.makespan();
  out.plan.sum_of_costs = from.sum_of_costs();
  out.plan.sum_of_costs_timesteps = from.sum_of_costs_timesteps();
  for (fleet::Statistic& statistic : from.statistics()) {
    out.plan.statistics.emplace_back(std::move(statistic.name()), statistic.value());
  }
  for (std::string& name : from.robots()) out.plan.robots.push_back({std::move(name), {}, {}});
  return out;
}

void to_wire(const PathPiece& path, fleet::RobotPlan& out) {
  const auto& [id, version, robot, robot_index, dof, piece, pieces, times, configurations,
               segments] = path;
  out.request_id(id);
  out.version(version);
  out.robot(robot);
  out.robot_index(robot_index);
  out.dof(dof);
  out.piece(piece);
  out.pieces(pieces);
  out.times(times);
  out.configurations(configurations);
  out.segments().resize(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& [from, to, solver, robots] = segments[i];
    out.segments()[i].from(from);
    out.segments()[i].to(to);
    out.segments()[i].solver(solver);
    out.segments()[i].robots(robots);
  }
}

PathPiece from_wire(fleet::RobotPlan& from) {
  PathPiece out;
  out.id = std::move(from.request_id());
  out.version = from.version();
  out.robot = std::move(from.robot());
  out.robot_index = from.robot_index();
  out.dof = from.dof();
  out.piece = from.piece();
  out.pieces = from.pieces();
  out.times = std::move(from.times());
  out.configurations = std::move(from.configurations());
  for (fleet::Segment& segment : from.segments()) {
    out.segments.push_back(
        {segment.from(), segment.to(), std::move(segment.solver()), std::move(segment.robots())});
  }
  return out;
}

}  // namespace accord::dds
