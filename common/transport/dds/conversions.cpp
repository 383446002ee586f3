#include "common/transport/dds/conversions.h"

#include <utility>

#include "common/transport/message_limits.h"

namespace accord::wire {
namespace {

using eprosima::fastcdr::Cdr;

// The next sequence's length, its elements still to come.
bool length_is_at_most(std::size_t most, Cdr& in) {
  std::uint32_t length = 0;
  in >> length;
  return length <= most;
}

void skip_head(Cdr& in) {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  in >> from >> to;
}

}  // namespace

bool counts_are_sound(const TaskBatch*, Cdr& in) {
  skip_head(in);
  std::uint64_t request = 0;
  SceneHash scene;
  in >> request >> scene.bytes;
  std::vector<std::uint8_t> hierarchy;
  in >> hierarchy;
  return length_is_at_most(kBatchItems, in);
}

bool counts_are_sound(const ResultBatch*, Cdr& in) {
  skip_head(in);
  return length_is_at_most(kBatchItems, in);
}

bool counts_are_sound(const Command*, Cdr& in) {
  skip_head(in);
  std::uint8_t kind = 0;
  in >> kind;
  return length_is_at_most(kKeys, in);
}

bool counts_are_sound(const Heartbeat*, Cdr& in) {
  skip_head(in);
  std::uint32_t idle_threads = 0;
  in >> idle_threads;
  return length_is_at_most(kKeys, in);
}

}  // namespace accord::wire

namespace accord::dds {
namespace {

wire::Key to_wire(const TaskKey& key) {
  wire::Key out;
  out.task(key.task);
  out.epoch(key.epoch);
  return out;
}

TaskKey from_wire(const wire::Key& key) {
  return {key.task(), key.epoch()};
}

}  // namespace

void to_wire(const TaskBatch& message, wire::TaskBatch& out) {
  const auto& [request, scene, hierarchy, tasks] = message;
  out.request(request);
  out.scene(scene.bytes);
  out.hierarchy(hierarchy);
  out.tasks().resize(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    out.tasks()[i].key(to_wire(tasks[i].key));
    out.tasks()[i].subproblem(tasks[i].subproblem);
  }
}

TaskBatch from_wire(wire::TaskBatch& from) {
  TaskBatch out{from.request(), {from.scene()}, std::move(from.hierarchy()), {}};
  for (wire::Task& task : from.tasks()) {
    out.tasks.push_back({from_wire(task.key()), std::move(task.subproblem())});
  }
  return out;
}

void to_wire(const Command& message, wire::Command& out) {
  const auto& [kind, tasks, scene, text] = message;
  out.kind(static_cast<std::uint8_t>(kind));
  for (const TaskKey& key : tasks) out.tasks().push_back(to_wire(key));
  out.scene(scene.bytes);
  out.text(text);
}

Command from_wire(wire::Command& from) {
  Command out{static_cast<Command::Kind>(from.kind()), {}, {from.scene()}, from.text().to_string()};
  for (const wire::Key& key : from.tasks()) out.tasks.push_back(from_wire(key));
  return out;
}

void to_wire(const ScenePiece& message, wire::ScenePiece& out) {
  const auto& [scene, total, offset, data] = message;
  out.scene(scene.bytes);
  out.total(total);
  out.offset(offset);
  out.data(data);
}

ScenePiece from_wire(wire::ScenePiece& from) {
  return {{from.scene()}, from.total(), from.offset(), std::move(from.data())};
}

void to_wire(const Announcement& message, wire::Announcement& out) {
  const auto& [protocol, version, host, process, threads, task_bytes, scene_bytes, leaving] =
      message;
  out.protocol(protocol);
  out.version(version);
  out.host(host);
  out.process(process);
  out.threads(threads);
  out.task_bytes(task_bytes);
  out.scene_bytes(scene_bytes);
  out.leaving(leaving);
}

Announcement from_wire(wire::Announcement& from) {
  return {from.protocol(), from.version().to_string(), from.host().to_string(), from.process(),
          from.threads(),  from.task_bytes(),          from.scene_bytes(),      from.leaving()};
}

void to_wire(const ResultBatch& message, wire::ResultBatch& out) {
  const auto& [results] = message;
  out.results().resize(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto& [key, outcome, resolution, seconds, text] = results[i];
    wire::Result& result = out.results()[i];
    result.key(to_wire(key));
    result.outcome(static_cast<std::uint8_t>(outcome));
    result.resolution(resolution);
    result.seconds(seconds);
    result.text(text);
  }
}

ResultBatch from_wire(wire::ResultBatch& from) {
  ResultBatch out;
  for (wire::Result& result : from.results()) {
    out.results.push_back(
        {from_wire(result.key()), static_cast<ResultItem::Outcome>(result.outcome()),
         std::move(result.resolution()), result.seconds(), result.text().to_string()});
  }
  return out;
}

void to_wire(const Heartbeat& message, wire::Heartbeat& out) {
  const auto& [idle_threads, tasks] = message;
  out.idle_threads(idle_threads);
  out.tasks().resize(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto& [key, begun, seconds] = tasks[i];
    out.tasks()[i].key(to_wire(key));
    out.tasks()[i].begun(begun);
    out.tasks()[i].seconds(seconds);
  }
}

Heartbeat from_wire(wire::Heartbeat& from) {
  Heartbeat out{from.idle_threads(), {}};
  for (const wire::Progress& task : from.tasks()) {
    out.tasks.push_back({from_wire(task.key()), task.begun(), task.seconds()});
  }
  return out;
}

void to_wire(const SceneRequest& message, wire::SceneRequest& out) {
  const auto& [scene, offset] = message;
  out.scene(scene.bytes);
  out.offset(offset);
}

SceneRequest from_wire(wire::SceneRequest& from) {
  return {{from.scene()}, from.offset()};
}

}  // namespace accord::dds
