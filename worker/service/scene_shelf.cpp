#include "worker/service/scene_shelf.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/geometry/tolerances.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "worker/solver.h"
#include "worker/worker.h"

namespace accord {
namespace {

SceneShelf::Solved trouble(ResultItem::Outcome outcome, std::string text) {
  SceneShelf::Solved out;
  out.result.outcome = outcome;
  out.result.text = std::move(text);
  return out;
}

}  // namespace

// A scene, and the worker in it, which keeps its roadmaps.
struct SceneShelf::Ready {
  explicit Ready(std::shared_ptr<const Scene> from)
      : scene(std::move(from)), world(scene, kPlanningMargin), worker(world) {}

  std::shared_ptr<const Scene> scene;
  CollisionWorld world;
  Worker worker;
};

SceneShelf::SceneShelf() = default;
SceneShelf::~SceneShelf() = default;

tl::expected<void, std::string> SceneShelf::add(const SceneHash& hash, BytesView bytes) {
  auto scene = decode_scene(bytes);
  if (!scene) return tl::unexpected(scene.error());
  auto ready = std::make_shared<const Ready>(*scene);
  const std::lock_guard lock(mutex_);
  scenes_[hash] = std::move(ready);
  return {};
}

void SceneShelf::remove(const SceneHash& hash) {
  const std::lock_guard lock(mutex_);
  scenes_.erase(hash);
}

std::shared_ptr<const SceneShelf::Ready> SceneShelf::find(const SceneHash& hash) const {
  const std::lock_guard lock(mutex_);
  const auto found = scenes_.find(hash);
  return found == scenes_.end() ? nullptr : found->second;
}

SceneShelf::Solved SceneShelf::solve(const TaskDesk::Job& job,
                                     const std::atomic<bool>& stop) const {
  const auto ready = find(job.scene);
  if (!ready) return trouble(ResultItem::Outcome::kHandedBack, "the scene is not here any more");
  const auto solvers = decode_hierarchy(job.hierarchy);
  if (!solvers) return trouble(ResultItem::Outcome::kRefused, "hierarchy: " + solvers.error());
  const auto is_unknown = [](const std::string& name) { return make_solver(name) == nullptr; };
  const auto unknown = std::ranges::find_if(*solvers, is_unknown);
  if (unknown != solvers->end()) {
    return trouble(ResultItem::Outcome::kRefused, "hierarchy: no solver \"" + *unknown + "\"");
  }
  const auto subproblem = decode_subproblem(job.subproblem, *ready->scene);
  if (!subproblem) {
    return trouble(ResultItem::Outcome::kRefused, "subproblem: " + subproblem.error());
  }
  const auto begin = std::chrono::steady_clock::now();
  Solved out;
  try {
    const Resolution resolution = ready->worker.solve(*subproblem, *solvers, stop);
    out.levels = tried_levels(*subproblem, *solvers, resolution);
    out.result.resolution = encode_resolution(resolution);
  } catch (const std::bad_alloc&) {
    return trouble(ResultItem::Outcome::kFailed, "not enough memory");
  }
  if (stop) return trouble(ResultItem::Outcome::kHandedBack, "stopped");
  out.result.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace accord
