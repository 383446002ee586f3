#include "worker/service/task_desk.h"

#include <algorithm>
#include <utility>

namespace accord {

std::optional<TaskDesk::Job> TaskDesk::next_job(Time now) {
  if (running_.size() >= settings_.info.threads) return std::nullopt;
  const auto job = std::ranges::find_if(
      waiting_, [&](const Job& waiting) { return ready_.contains(waiting.scene); });
  if (job == waiting_.end()) return std::nullopt;
  running_.push_back({*job, now});
  waiting_.erase(job);
  return running_.back().job;
}

void TaskDesk::on_ended(const Job& job, ResultItem result) {
  const auto found =
      std::ranges::find_if(running_, [&](const Running& run) { return run.job.key == job.key; });
  if (found == running_.end()) return;
  const bool is_wanted = !found->revoked && coordinator_ == job.coordinator;
  running_.erase(found);
  if (!is_wanted) return;
  result.key = job.key;
  send(job.coordinator, ResultBatch{{std::move(result)}});
}

std::vector<TaskKey> TaskDesk::take_revoked() {
  return std::exchange(revoked_, {});
}

std::optional<TaskDesk::Scene> TaskDesk::take_scene() {
  if (arrived_.empty()) return std::nullopt;
  Scene scene = std::move(arrived_.front());
  arrived_.pop_front();
  return scene;
}

void TaskDesk::on_scene_ready(const SceneHash& scene) {
  making_ready_.erase(scene);
  ready_.insert(scene);
}

void TaskDesk::on_scene_unusable(const SceneHash& scene, const std::string& why) {
  making_ready_.erase(scene);
  std::erase_if(waiting_, [&](const Job& job) {
    if (job.scene != scene) return false;
    answer(job.key, ResultItem::Outcome::kRefused, "the scene: " + why);
    return true;
  });
}

std::vector<SceneHash> TaskDesk::take_forgotten() {
  return std::exchange(forgotten_, {});
}

void TaskDesk::answer(const TaskKey& key, ResultItem::Outcome outcome, const std::string& text) {
  if (!coordinator_) return;
  ResultItem item;
  item.key = key;
  item.outcome = outcome;
  item.text = text;
  send(*coordinator_, ResultBatch{{std::move(item)}});
}

void TaskDesk::leave() {
  if (leaving_) return;
  leaving_ = true;
  settings_.info.leaving = true;
  for (const Job& job : waiting_) answer(job.key, ResultItem::Outcome::kHandedBack, "leaving");
  waiting_.clear();
  announce();
}

void TaskDesk::on_event(const BusEvent& event, Time now) {
  if (std::holds_alternative<PeerLost>(event.what)) {
    if (coordinator_ == event.peer) drop_coordinator();
    return;
  }
  if (std::holds_alternative<PeerAppeared>(event.what)) {
    if (!coordinator_) speak_at_ = now;
    return;
  }
  const Message& message = std::get<Message>(event.what);
  if (coordinator_ == event.peer) heard_ = now;
  if (const auto* command = std::get_if<Command>(&message)) on_command(event.peer, *command, now);
  const auto* batch = std::get_if<TaskBatch>(&message);
  if (batch != nullptr && !coordinator_) {  // it has overtaken the welcome
    coordinator_ = event.peer;
    heard_ = now;
  }
  if (coordinator_ != event.peer) return;  // only who has taken it on gives it work
  if (batch != nullptr) on_batch(event.peer, *batch, now);
  if (const auto* piece = std::get_if<ScenePiece>(&message)) on_piece(*piece, now);
}

void TaskDesk::on_command(EndpointId from, const Command& command, Time now) {
  switch (command.kind) {
    case Command::Kind::kWelcome:
      if (coordinator_ && coordinator_ != from) return;  // it has one
      coordinator_ = from;
      refusal_.clear();
      heard_ = now;
      return;
    case Command::Kind::kRefuse:
      if (coordinator_ && coordinator_ != from) return;
      refusal_ = command.text.empty() ? "refused" : command.text;
      drop_coordinator();
      return;
    case Command::Kind::kAlive:
      return;
    case Command::Kind::kRevoke:
      if (coordinator_ != from) return;
      for (const TaskKey& key : command.tasks) {
        std::erase_if(waiting_, [&](const Job& job) { return job.key == key; });
        for (Running& run : running_) {
          if (run.job.key != key || run.revoked) continue;
          run.revoked = true;
          revoked_.push_back(key);
        }
      }
      return;
    case Command::Kind::kForget:
      if (coordinator_ != from) return;
      wanted_.erase(command.scene);
      if (ready_.erase(command.scene) > 0) forgotten_.push_back(command.scene);
      return;
  }
}

void TaskDesk::on_batch(EndpointId from, const TaskBatch& batch, Time now) {
  for (const TaskItem& item : batch.tasks) {
    const auto is_same = [&](const Job& job) { return job.key == item.key; };
    // It may come twice.
    if (std::ranges::any_of(waiting_, is_same)) continue;
    if (std::ranges::any_of(running_, [&](const Running& run) { return is_same(run.job); })) {
      continue;
    }
    if (leaving_) {
      answer(item.key, ResultItem::Outcome::kHandedBack, "leaving");
    } else if (item.subproblem.size() > settings_.info.task_bytes) {
      answer(item.key, ResultItem::Outcome::kRefused,
             "the subproblem is larger than this worker takes");
    } else {
      waiting_.push_back({from, item.key, batch.scene, batch.hierarchy, item.subproblem});
    }
  }
  if (!waiting_.empty()) want(batch.scene, now);
}

void TaskDesk::want(const SceneHash& scene, Time now) {
  if (ready_.contains(scene) || making_ready_.contains(scene) || wanted_.contains(scene)) return;
  wanted_.emplace(scene, Wanted{SceneAssembly(scene), now});
  send(*coordinator_, SceneRequest{scene, 0});
}

void TaskDesk::on_piece(const ScenePiece& piece, Time now) {
  const auto found = wanted_.find(piece.scene);
  if (found == wanted_.end()) return;
  Wanted& wanted = found->second;
  if (piece.total > settings_.info.scene_bytes) {
    on_scene_unusable(piece.scene, "it is larger than this worker takes");
    wanted_.erase(found);
    return;
  }
  const std::uint64_t before = wanted.assembly.next_offset();
  wanted.assembly.add(piece);
  if (wanted.assembly.next_offset() > before) wanted.asked = now;
  if (!wanted.assembly.complete()) return;
  auto bytes = wanted.assembly.take();
  if (!bytes) {  // began anew
    send(*coordinator_, SceneRequest{piece.scene, 0});
    wanted.asked = now;
    return;
  }
  making_ready_.insert(piece.scene);
  arrived_.push_back({piece.scene, std::move(*bytes)});
  wanted_.erase(found);
}

// What came from it is of no use: it has given this worker up, or will have.
void TaskDesk::drop_coordinator() {
  coordinator_.reset();
  waiting_.clear();
  wanted_.clear();
  outbox_.clear();
  for (Running& run : running_) {
    if (run.revoked) continue;
    run.revoked = true;
    revoked_.push_back(run.job.key);
  }
}

void TaskDesk::announce() {
  send({}, settings_.info);
}

void TaskDesk::say_alive(Time now) {
  Heartbeat heartbeat;
  heartbeat.idle_threads =
      settings_.info.threads -
      static_cast<std::uint32_t>(std::min<std::size_t>(running_.size(), settings_.info.threads));
  for (const Running& run : running_) {
    if (run.revoked) continue;
    heartbeat.tasks.push_back(
        {run.job.key, true, std::chrono::duration<double>(now - run.since).count()});
  }
  for (const Job& job : waiting_) heartbeat.tasks.push_back({job.key, false, 0});
  send(*coordinator_, std::move(heartbeat));
}

void TaskDesk::on_time(Time now) {
  if (coordinator_ && now - heard_ >= settings_.patience) drop_coordinator();
  if (now >= speak_at_) {
    speak_at_ = now + settings_.heartbeat;
    // One at a time: they say how it is, not how it was.
    const auto is_old = [](const Pending& pending) {
      return std::holds_alternative<Heartbeat>(pending.message) ||
             std::holds_alternative<Announcement>(pending.message);
    };
    std::erase_if(outbox_, is_old);
    if (coordinator_) say_alive(now);
    if (!coordinator_ || leaving_) announce();
  }
  for (auto& [hash, wanted] : wanted_) {
    if (now - wanted.asked < settings_.patience || !coordinator_) continue;
    wanted.asked = now;
    send(*coordinator_, SceneRequest{hash, wanted.assembly.next_offset()});
  }
}

std::optional<TaskDesk::Time> TaskDesk::next_deadline() const {
  Time next = speak_at_;
  if (coordinator_) next = std::min(next, heard_ + settings_.patience);
  for (const auto& [hash, wanted] : wanted_) {
    next = std::min(next, wanted.asked + settings_.patience);
  }
  if (!outbox_.empty()) next = std::min(next, blocked_until_);
  return next;
}

std::optional<TaskDesk::Outgoing> TaskDesk::next_outgoing(Time now) const {
  if (outbox_.empty() || blocked_until_ > now) return std::nullopt;
  return Outgoing{outbox_.front().to, outbox_.front().message};
}

void TaskDesk::on_published(Published outcome, Time now) {
  switch (outcome) {
    case Published::kFull:
      blocked_until_ = now + settings_.retry;
      return;
    case Published::kNoPeer:
      // An announcement is for later; anything else was for somebody who is gone.
    case Published::kSent:
    case Published::kInvalid:
    case Published::kClosed:
      outbox_.pop_front();
      return;
  }
}

}  // namespace accord
