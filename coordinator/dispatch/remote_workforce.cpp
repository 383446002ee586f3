#include "coordinator/dispatch/remote_workforce.h"

#include <algorithm>
#include <utility>

#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"

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

RemoteWorkforce::RemoteWorkforce(std::unique_ptr<TaskPort> port, std::shared_ptr<const Scene> scene,
                                 const std::vector<std::string>& solvers)
    : port_(std::move(port)), scene_(std::move(scene)) {
  RequestWork work;
  auto bytes = std::make_shared<const Bytes>(encode_scene(*scene_));
  work.scene = hash_of(*bytes);
  work.scene_bytes = std::move(bytes);
  work.hierarchy = encode_hierarchy(solvers);
  port_->open(std::move(work));
}

std::vector<Resolution> RemoteWorkforce::solve(const std::vector<Subproblem>& subproblems,
                                               const std::atomic<bool>& stop) {
  std::vector<Resolution> resolutions(subproblems.size());
  std::map<TaskId, std::size_t> place;
  std::vector<NewTask> tasks;
  for (std::size_t i = 0; i < subproblems.size(); ++i) {
    const TaskId id = port_->next_id();
    place.emplace(id, i);
    tasks.push_back({id, encode_subproblem(subproblems[i]), weight_of(subproblems[i])});
  }
  port_->add(std::move(tasks));
  while (!place.empty()) {
    const auto finished = port_->wait(stop);
    if (!finished) break;
    const auto found = place.find(finished->task);
    if (found == place.end()) continue;  // of an earlier call that was stopped
    const Subproblem& subproblem = subproblems[found->second];
    if (finished->how != FinishedTask::How::kDone) {
      throw TaskFailure(finished->text, encode_subproblem(subproblem));
    }
    auto resolution = decode_resolution(finished->resolution, *scene_, subproblem);
    if (!resolution) {
      port_->reject(*finished, "its resolution does not hold: " + resolution.error());
      continue;
    }
    port_->accept(finished->task);
    resolutions[found->second] = std::move(*resolution);
    place.erase(found);
  }
  return resolutions;
}

}  // namespace accord
