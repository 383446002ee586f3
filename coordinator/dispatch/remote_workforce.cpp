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

RemoteWorkforce::RemoteWorkforce(std::unique_ptr<TaskPort> port, const CollisionWorld& world,
                                 const std::vector<std::string>& solvers)
    : port_(std::move(port)), world_(world) {
  RequestWork work;
  auto bytes = std::make_shared<const Bytes>(encode_scene(world.scene()));
  work.scene = hash_of(*bytes);
  work.scene_bytes = std::move(bytes);
  work.hierarchy = encode_hierarchy(solvers);
  port_->open(std::move(work));
}

std::vector<Resolution> RemoteWorkforce::solve(const std::vector<Subproblem>& subproblems,
                                               const std::atomic<bool>& stop) {
  std::vector<Resolution> resolutions(subproblems.size());
  std::map<TaskId, Sent> sent;
  std::vector<NewTask> tasks;
  for (std::size_t i = 0; i < subproblems.size(); ++i) {
    const TaskId id = port_->next_id();
    sent.emplace(id, Sent{i, {}});
    tasks.push_back({id, encode_subproblem(subproblems[i]), weight_of(subproblems[i])});
  }
  port_->add(std::move(tasks));
  while (!sent.empty()) {
    const auto finished = port_->wait(stop);
    if (!finished) break;
    const auto found = sent.find(finished->task);
    if (found == sent.end()) continue;  // of an earlier call that was stopped
    const std::size_t i = found->second.place;
    if (auto resolution = take(*finished, subproblems[i], found->second)) {
      resolutions[i] = std::move(*resolution);
      sent.erase(found);
    }
  }
  return resolutions;
}

std::optional<Resolution> RemoteWorkforce::take(const FinishedTask& finished,
                                                const Subproblem& subproblem, Sent& sent) {
  if (finished.how != FinishedTask::How::kDone) {
    throw TaskFailure(finished.text, encode_subproblem(subproblem));
  }
  auto resolution = decode_resolution(finished.resolution, world_.scene(), subproblem);
  const auto fault = resolution ? resolution_fault(world_, subproblem, *resolution)
                                : std::optional(resolution.error());
  if (!fault) {
    port_->accept(finished.task);
    return std::move(*resolution);
  }
  const std::string why = "its resolution does not hold: " + *fault;
  // Two that say the same are no liars: the solvers are wrong.
  if (sent.refused == finished.resolution) throw TaskFailure(why, encode_subproblem(subproblem));
  sent.refused = finished.resolution;
  port_->reject(finished, why);
  return std::nullopt;
}

}  // namespace accord
