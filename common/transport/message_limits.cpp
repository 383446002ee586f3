#include "common/transport/message_limits.h"

#include <algorithm>
#include <array>

namespace accord {
namespace {

constexpr std::array<Role, kMessageKinds> kSenders = {
    Role::kCoordinator, Role::kCoordinator, Role::kCoordinator, Role::kWorker,
    Role::kWorker,      Role::kWorker,      Role::kWorker};

using Fault = std::optional<std::string>;

Fault at_most(std::size_t value, std::size_t most, const char* of_what) {
  if (value <= most) return std::nullopt;
  return std::to_string(value) + " " + of_what + "; expected at most " + std::to_string(most);
}

Fault first_of(std::initializer_list<Fault> faults) {
  for (const Fault& fault : faults) {
    if (fault) return fault;
  }
  return std::nullopt;
}

// Items of a batch, each with a payload.
template <typename Items, typename Payload>
Fault batch_fault(const Items& items, Payload payload, std::size_t most, const char* what) {
  if (auto fault = at_most(items.size(), kBatchItems, what)) return fault;
  std::size_t bytes = 0;
  for (const auto& item : items) {
    if (auto fault = at_most(payload(item).size(), most, "bytes of one of them")) return fault;
    bytes += payload(item).size();
  }
  return at_most(bytes, kBatchBytes, "bytes of payloads in a batch");
}

Fault fault_of(const TaskBatch& batch) {
  return first_of(
      {at_most(batch.hierarchy.size(), kHierarchyBytes, "bytes of solver names"),
       batch_fault(
           batch.tasks, [](const TaskItem& item) -> const Bytes& { return item.subproblem; },
           kTaskBytes, "tasks")});
}

Fault fault_of(const Command& command) {
  if (command.kind > Command::Kind::kForget) return "a command of an unknown kind";
  return first_of({at_most(command.tasks.size(), kKeys, "tasks"),
                   at_most(command.text.size(), kTextBytes, "bytes of text")});
}

Fault fault_of(const ScenePiece& piece) {
  if (piece.offset > piece.total || piece.data.size() > piece.total - piece.offset) {
    return "a piece that ends beyond its scene";
  }
  return first_of({at_most(piece.data.size(), kPieceBytes, "bytes of a scene's piece"),
                   at_most(piece.total, limits::kSceneWireBytes, "bytes of a scene")});
}

Fault fault_of(const Announcement& announcement) {
  return first_of({at_most(announcement.version.size(), kTextBytes, "bytes of a version"),
                   at_most(announcement.host.size(), kTextBytes, "bytes of a host's name")});
}

Fault fault_of(const ResultBatch& batch) {
  for (const ResultItem& item : batch.results) {
    if (item.outcome > ResultItem::Outcome::kFailed) return "a result of an unknown outcome";
    if (auto fault = at_most(item.text.size(), kTextBytes, "bytes of text")) return fault;
  }
  return batch_fault(
      batch.results, [](const ResultItem& item) -> const Bytes& { return item.resolution; },
      kResultBytes, "results");
}

Fault fault_of(const Heartbeat& heartbeat) {
  return at_most(heartbeat.tasks.size(), kKeys, "tasks");
}

Fault fault_of(const SceneRequest&) {
  return std::nullopt;
}

// Sizes of what is not a payload, roughly: as CDR lays them out.
constexpr std::size_t kHead = 64;
constexpr std::size_t kItem = 48;

std::size_t bytes_of(const TaskBatch& batch) {
  std::size_t bytes = kHead + batch.hierarchy.size();
  for (const TaskItem& item : batch.tasks) bytes += kItem + item.subproblem.size();
  return bytes;
}
std::size_t bytes_of(const Command& command) {
  return kHead + 16 * command.tasks.size() + command.text.size();
}
std::size_t bytes_of(const ScenePiece& piece) {
  return kHead + piece.data.size();
}
std::size_t bytes_of(const Announcement& announcement) {
  return kHead + announcement.version.size() + announcement.host.size();
}
std::size_t bytes_of(const ResultBatch& batch) {
  std::size_t bytes = kHead;
  for (const ResultItem& item : batch.results) {
    bytes += kItem + item.resolution.size() + item.text.size();
  }
  return bytes;
}
std::size_t bytes_of(const Heartbeat& heartbeat) {
  return kHead + kItem * heartbeat.tasks.size();
}
std::size_t bytes_of(const SceneRequest&) {
  return kHead;
}

}  // namespace

Role sender_of(const Message& message) {
  return kSenders[message.index()];
}

std::optional<std::string> message_fault(const Message& message) {
  return std::visit([](const auto& kind) { return fault_of(kind); }, message);
}

std::size_t wire_bytes(const Message& message) {
  return std::visit([](const auto& kind) { return bytes_of(kind); }, message);
}

}  // namespace accord
