#include "coordinator/dispatch/remote_workforce.h"

#include <algorithm>
#include <utility>

#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/planning/resolution_check.h"

namespace accord {
namespace {

// A guess at how long a subproblem takes, next to others: teams search longer, large ones much.
double weight_of(const Subproblem& subproblem) {
  const auto robots = static_cast<double>(subproblem.tasks.size());
  std::size_t dof = 0;
  for (const Task& task : subproblem.tasks) dof = std::max(dof, task.start.size());
  return robots * robots * static_cast<double>(dof * dof);
}

}  // namespace

RemoteWorkforce::RemoteWorkforce(Bus& bus, TaskBoard& board, RequestId request,
                                 const CollisionWorld& world,
                                 const std::vector<std::string>& solvers, Turn turn)
    : bus_(bus),
      board_(board),
      request_(request),
      world_(world),
      turn_(std::move(turn)),
      next_task_(request << 32U) {
  RequestWork work;
  work.request = request;
  auto bytes = std::make_shared<const Bytes>(encode_scene(world.scene()));
  work.scene = hash_of(*bytes);
  work.scene_bytes = std::move(bytes);
  work.hierarchy = encode_hierarchy(solvers);
  board_.add(std::move(work), {});
}

RemoteWorkforce::~RemoteWorkforce() {
  board_.end(request_);
}

void RemoteWorkforce::run_loop_once() {
  while (const auto event = bus_.take()) board_.on_event(*event, now_);
  board_.on_time(now_);
  while (const auto out = board_.next_outgoing(now_)) {
    board_.on_published(out->to, bus_.publish(out->to, out->message), now_);
  }
  now_ = turn_(bus_, board_.next_deadline());
}

std::vector<Resolution> RemoteWorkforce::solve(const std::vector<Subproblem>& subproblems,
                                               const std::atomic<bool>& stop) {
  const TaskId first = next_task_;
  next_task_ += subproblems.size();
  std::vector<NewTask> tasks;
  sent_.clear();
  refused_.assign(subproblems.size(), {});
  for (std::size_t i = 0; i < subproblems.size(); ++i) {
    sent_.push_back(encode_subproblem(subproblems[i]));
    tasks.push_back({first + i, sent_.back(), weight_of(subproblems[i])});
  }
  board_.add(request_, std::move(tasks));
  std::vector<Resolution> resolutions(subproblems.size());
  for (std::size_t left = subproblems.size(); left > 0 && !stop;) {
    run_loop_once();
    take_results(subproblems, first, resolutions, left);
  }
  return resolutions;
}

void RemoteWorkforce::take_results(const std::vector<Subproblem>& subproblems, TaskId first,
                                   std::vector<Resolution>& out, std::size_t& left) {
  while (const auto finished = board_.take_finished()) {
    const std::size_t i = finished->task - first;
    if (finished->how != FinishedTask::How::kDone) throw TaskFailure(finished->text, sent_[i]);
    auto resolution = decode_resolution(finished->resolution, world_.scene(), subproblems[i]);
    const auto fault = resolution ? resolution_fault(world_, subproblems[i], *resolution)
                                  : std::optional(resolution.error());
    if (fault) {
      refuse(*finished, i, *fault);
      continue;
    }
    out[i] = std::move(*resolution);
    --left;
  }
}

void RemoteWorkforce::refuse(const FinishedTask& finished, std::size_t i,
                             const std::string& fault) {
  const std::string why = "its resolution does not hold: " + fault;
  if (refused_[i] == finished.resolution) throw TaskFailure(why, sent_[i]);
  refused_[i] = finished.resolution;
  board_.reject(finished, why);
}

}  // namespace accord
