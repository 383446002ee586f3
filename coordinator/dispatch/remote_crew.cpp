#include "coordinator/dispatch/remote_crew.h"

#include <algorithm>
#include <utility>

#include "common/geometry/query_counter.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/model/roadmap_places.h"
#include "common/planning/levels.h"
#include "common/planning/resolution_check.h"
#include "common/runtime/log.h"
#include "common/transport/task_name.h"
#include "coordinator/dispatch/roadmap_partners.h"
#include "coordinator/dispatch/worker_scene.h"

namespace accord {
namespace {

// The board's guesses of what a unit of weight takes begin with a millisecond.
constexpr double kWeightPerSecond = 1e3;
constexpr double kLeastWeight = 1e-3;

}  // namespace

RemoteCrew::RemoteCrew(std::unique_ptr<TaskPort> port, const CollisionWorld& world,
                       std::string request, AttemptTally* tally)
    : port_(std::move(port)),
      world_(world),
      request_(std::move(request)),
      tally_(tally),
      scene_(std::make_shared<const Bytes>(encode_scene(scene_for_workers(world.scene())))),
      places_(roadmap_places(world.scene())) {
  RequestWork work;
  work.name = request_;
  work.partners = roadmap_partners(world, places_);
  work.scene = hash_of(*scene_);
  work.scene_bytes = scene_;
  port_->open(std::move(work));
}

void RemoteCrew::begin(std::vector<Attempt> attempts) {
  std::vector<NewTask> tasks;
  for (Attempt& attempt : attempts) {
    const TaskId id = port_->next_id();
    const double weight = std::max(kLeastWeight, kWeightPerSecond * attempt.seconds);
    Bytes hierarchy = encode_hierarchy(attempt.solvers, request_);
    tasks.push_back({id, hierarchy, encode_subproblem(*attempt.subproblem), weight,
                     attempt.is_ahead, places_of(*attempt.subproblem)});
    tasks_.emplace(attempt.ticket, id);
    under_way_.emplace(id, UnderWay{attempt.ticket,
                                    std::move(attempt.subproblem),
                                    std::move(attempt.solvers),
                                    std::move(hierarchy),
                                    {}});
  }
  port_->add(std::move(tasks));
}

std::vector<RoadmapPlace> RemoteCrew::places_of(const Subproblem& subproblem) const {
  std::vector<RoadmapPlace> places;
  for (const Task& task : subproblem.tasks) places.push_back(places_[task.robot.index()]);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void RemoteCrew::hurry(const std::vector<Ticket>& tickets) {
  std::vector<TaskId> tasks;
  for (const Ticket ticket : tickets) {
    const auto found = tasks_.find(ticket);
    if (found != tasks_.end()) tasks.push_back(found->second);
  }
  if (!tasks.empty()) port_->hurry(tasks);
}

void RemoteCrew::drop(const std::vector<Ticket>& tickets) {
  std::vector<TaskId> tasks;
  for (const Ticket ticket : tickets) {
    const auto found = tasks_.find(ticket);
    if (found == tasks_.end()) continue;
    tasks.push_back(found->second);
    under_way_.erase(found->second);
    tasks_.erase(found);
  }
  if (!tasks.empty()) port_->cancel(tasks);
}

std::vector<Attempted> RemoteCrew::wait(const std::atomic<bool>& stop) {
  while (const auto finished = port_->wait(stop)) {
    const auto found = under_way_.find(finished->task);
    if (found == under_way_.end()) {  // dropped while it was on its way
      port_->accept(finished->task);
      continue;
    }
    auto attempted = answer(*finished, found->second);
    if (!attempted) continue;
    tasks_.erase(attempted->ticket);
    under_way_.erase(found);
    std::vector<Attempted> out;
    out.push_back(std::move(*attempted));
    return out;
  }
  return {};
}

std::optional<Attempted> RemoteCrew::answer(const FinishedTask& finished, UnderWay& task) {
  Attempted out;
  out.ticket = task.ticket;
  out.doer = {task_name(finished.task), to_string(finished.worker), 0};
  out.seconds = finished.seconds;
  const auto fail = [&](const std::string& why) {
    out.failure = std::make_exception_ptr(
        TaskFailure({*scene_, task.hierarchy, encode_subproblem(*task.subproblem), why}));
    return std::move(out);
  };
  if (finished.how != FinishedTask::How::kDone) return fail(finished.text);
  auto resolution = decode_resolution(finished.resolution, world_.scene(), *task.subproblem);
  if (const auto fault = fault_of(*task.subproblem, resolution)) {
    const std::string why = "its resolution does not hold: " + *fault;
    log(LogLevel::kDebug, why,  // the board tells people
        {{"request", request_}, {"task", out.doer.task}, {"worker", out.doer.worker}});
    // Two that say the same are no liars: the solvers are wrong.
    if (task.refused == finished.resolution) {
      port_->accept(finished.task);
      return fail(why);
    }
    task.refused = finished.resolution;
    port_->reject(finished, why);
    return std::nullopt;
  }
  port_->accept(finished.task);
  log_ended(finished, *resolution);
  if (tally_ != nullptr) tally_->count(tried_levels(*task.subproblem, task.solvers, *resolution));
  out.resolution = std::move(*resolution);
  return out;
}

void RemoteCrew::log_ended(const FinishedTask& finished, const Resolution& resolution) const {
  if (!logs(LogLevel::kDebug)) return;
  log(LogLevel::kDebug, "task ended",
      {{"request", request_},
       {"task", task_name(finished.task)},
       {"worker", to_string(finished.worker)},
       {"outcome", to_string(outcome_of(resolution))},
       {"solver", resolution.solver},
       {"seconds", finished.seconds}});
}

std::optional<std::string> RemoteCrew::fault_of(
    const Subproblem& subproblem, const tl::expected<Resolution, std::string>& resolution) const {
  if (!resolution) return resolution.error();
  const SeparateCost not_of_planning;
  return resolution_fault(world_, subproblem, *resolution);
}

std::size_t RemoteCrew::hands() const {
  return std::max<std::size_t>(1, port_->threads());
}

}  // namespace accord
