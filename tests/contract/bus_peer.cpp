// A worker that answers each task with a result of the task's own bytes, for tests that need a
// process of its own to kill.
//
//   bus_peer DOMAIN CLUSTER udp|shm|both
//
// Goes on until it is killed, or told to forget a scene.
#include <chrono>
#include <iostream>
#include <string>

#include "common/transport/dds_bus.h"

namespace {

using namespace accord;

ResultBatch answer(const TaskBatch& batch) {
  ResultBatch out;
  for (const TaskItem& task : batch.tasks) {
    out.results.push_back({task.key, ResultItem::Outcome::kDone, task.subproblem, 0, {}});
  }
  return out;
}

// False when it is time to go.
bool serve(Bus& bus, const BusEvent& event) {
  const auto* message = std::get_if<Message>(&event.what);
  if (message == nullptr) return true;
  if (const auto* batch = std::get_if<TaskBatch>(message)) {
    while (bus.publish(event.peer, answer(*batch)) == Published::kFull) {
    }
  }
  const auto* command = std::get_if<Command>(message);
  return command == nullptr || command->kind != Command::Kind::kForget;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string transport = argv[3];
  DdsOptions options;
  options.domain = static_cast<std::uint32_t>(std::stoul(argv[1]));
  options.cluster = argv[2];
  options.interfaces = {"127.0.0.1"};
  options.transport = transport == "udp"   ? DdsOptions::Transport::kUdp
                      : transport == "shm" ? DdsOptions::Transport::kSharedMemory
                                           : DdsOptions::Transport::kBoth;
  const auto bus = make_dds_bus(Role::kWorker, options);
  if (!bus) {
    std::cerr << bus.error() << '\n';
    return 1;
  }
  while (true) {
    (*bus)->wait_for_event(std::chrono::seconds(1));
    while (const auto event = (*bus)->take()) {
      if (!serve(**bus, *event)) return 0;
    }
  }
}
