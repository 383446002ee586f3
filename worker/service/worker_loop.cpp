#include "worker/service/worker_loop.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <spdlog/spdlog.h>

namespace accord {
namespace {

// Who is asked to end is given so long for what it has begun.
constexpr auto kPatience = std::chrono::seconds(10);
// Who had a coordinator and hears from none for so long is not found by it any more: DDS may keep
// two apart for good of which only one has noticed that they were.
constexpr auto kLonely = std::chrono::seconds(4);

}  // namespace

WorkerLoop::WorkerLoop(Bus& bus, const TaskDesk::Settings& settings, WorkerTally& tally)
    : bus_(bus),
      tally_(tally),
      desk_(settings),
      threads_(shelf_, settings.info.threads, [&bus] { bus.wake(); }) {
  tally_.note_new_bus();
}

void WorkerLoop::drain() {
  drain_ = true;
  bus_.wake();
}

WorkerLoop::End WorkerLoop::run() {
  std::optional<TaskDesk::Time> end, lonely_since;
  std::optional<EndpointId> coordinator;
  while (true) {
    if (drain_ && !end) {
      desk_.leave();
      end = now() + kPatience;
      spdlog::info("leaving: no more tasks");
    }
    turn();
    if (desk_.coordinator() != coordinator) {
      coordinator = desk_.coordinator();
      if (coordinator) spdlog::info("works for coordinator {}", to_string(*coordinator));
      lonely_since = coordinator ? std::nullopt : std::optional(now());
      if (!coordinator) {
        spdlog::info("works for nobody{}{}", desk_.refusal().empty() ? "" : ": ", desk_.refusal());
      }
    }
    if (end && (desk_.is_idle() || now() >= *end)) return End::kDrained;
    if (lonely_since && desk_.refusal().empty() && now() - *lonely_since >= kLonely) {
      return End::kForgotten;
    }
    const TaskDesk::Time time = now();
    const auto deadline = desk_.next_deadline();
    auto wait = TaskDesk::Time(std::chrono::milliseconds(100));
    if (deadline) wait = std::clamp(*deadline - time, TaskDesk::Time(0), wait);
    bus_.wait_for_event(wait);
  }
}

void WorkerLoop::turn() {
  const TaskDesk::Time time = now();
  while (const auto event = bus_.take()) desk_.on_event(*event, time);
  while (auto outcome = threads_.take()) {
    if (auto* ended = std::get_if<JobThreads::Ended>(&*outcome)) {
      tally_.count(ended->result, ended->levels);
      desk_.on_ended(ended->job, std::move(ended->result));
    } else {
      const auto& scene = std::get<JobThreads::SceneOutcome>(*outcome);
      if (scene.why_not.empty()) {
        desk_.on_scene_ready(scene.scene);
      } else {
        spdlog::warn("a scene is of no use: {}", scene.why_not);
        desk_.on_scene_unusable(scene.scene, scene.why_not);
      }
    }
  }
  desk_.on_time(time);
  while (auto scene = desk_.take_scene()) threads_.make_ready(std::move(*scene));
  for (const SceneHash& scene : desk_.take_forgotten()) shelf_.remove(scene);
  for (const TaskKey& key : desk_.take_revoked()) threads_.stop(key);
  while (auto job = desk_.next_job(time)) threads_.start(std::move(*job));
  while (const auto out = desk_.next_outgoing(time)) {
    desk_.on_published(bus_.publish(out->to, out->message), time);
  }
  tally_.note_turn({desk_.running(), desk_.waiting(), desk_.coordinator().has_value(),
                    desk_.is_leaving(), bus_.counters()});
}

}  // namespace accord
