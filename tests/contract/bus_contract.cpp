#include "tests/contract/bus_contract.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "common/transport/message_limits.h"
#include "common/transport/scene_pieces.h"

namespace accord::bus_contract {
namespace {

using namespace std::chrono_literals;

constexpr Bus::Duration kPatience = 20s;  // how long anything may take that has to happen
constexpr Bus::Duration kQuiet = 100ms;   // how long nothing is to happen

// An endpoint and what it has been given.
struct Party {
  explicit Party(std::unique_ptr<Bus> endpoint) : bus(std::move(endpoint)) {}

  void take_all() {
    while (auto event = bus->take()) events.push_back(std::move(*event));
  }

  // Waits in small steps: the network's time moves, whoever's clock it is.
  bool until(const std::function<bool()>& holds, Bus::Duration patience = kPatience) {
    constexpr Bus::Duration kStep = 10ms;
    for (Bus::Duration spent{0};; spent += kStep) {
      take_all();
      if (holds()) return true;
      if (spent >= patience) return false;
      const auto begin = std::chrono::steady_clock::now();
      if (bus->wait_for_event(kStep)) spent -= kStep - (std::chrono::steady_clock::now() - begin);
    }
  }
  void listen(Bus::Duration time) {
    until([] { return false; }, time);
  }

  bool sees(const Party& other) const { return bus->is_present(other.bus->self()); }

  template <typename Kind>
  std::vector<Kind> received() const {
    std::vector<Kind> out;
    for (const BusEvent& event : events) {
      const auto* message = std::get_if<Message>(&event.what);
      if (message == nullptr) continue;
      if (const auto* kind = std::get_if<Kind>(message)) out.push_back(*kind);
    }
    return out;
  }
  std::size_t messages() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        events, [](const BusEvent& e) { return std::holds_alternative<Message>(e.what); }));
  }
  template <typename What>
  std::size_t count(const Party& about) const {
    return static_cast<std::size_t>(std::ranges::count_if(events, [&](const BusEvent& e) {
      return e.peer == about.bus->self() && std::holds_alternative<What>(e.what);
    }));
  }

  std::unique_ptr<Bus> bus;
  std::vector<BusEvent> events;
};

[[noreturn]] void broken(const std::string& what) {
  throw std::runtime_error(what);
}

void require(bool holds, const char* what) {
  if (!holds) broken(what);
}

void meet(Party& a, Party& b) {
  require(a.until([&] { return a.sees(b); }), "a peer never appeared");
  require(b.until([&] { return b.sees(a); }), "a peer never appeared");
}

Heartbeat heartbeat(std::uint32_t number) {
  return {number, {}};
}

TaskBatch batch(std::uint64_t task, std::size_t bytes) {
  return {1, {}, {}, {{{task, 0}, Bytes(bytes, static_cast<std::uint8_t>(task))}}};
}

// Publishes, and tries again while it is full and the receiver makes room.
void deliver(Party& from, Party& to, const Message& message) {
  for (int tries = 0; tries < 10'000; ++tries) {
    const Published outcome = from.bus->publish(to.bus->self(), message);
    if (outcome == Published::kSent) return;
    require(outcome == Published::kFull, "a present peer could not be published to");
    to.bus->wait_for_event(1ms);
    to.take_all();
  }
  broken("room was never made");
}

// ---- Presence ----

void peers_find_each_other(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party first(world.join(Role::kWorker));
  Party second(world.join(Role::kWorker));
  meet(coordinator, first);
  meet(coordinator, second);
  require(coordinator.count<PeerAppeared>(first) == 1, "a peer appeared more than once");
  require(coordinator.bus->peers().size() == 2, "there are other peers than joined");
  first.listen(kQuiet);
  require(!first.sees(second), "workers see each other");
}

void who_leaves_is_lost(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  const EndpointId id = worker.bus->self();
  worker.bus.reset();
  require(coordinator.until([&] { return !coordinator.bus->is_present(id); }, 1s),
          "who said goodbye was not lost within a second");
  require(coordinator.bus->publish(id, Command{}) == Published::kNoPeer,
          "who is lost can be published to");
}

void who_comes_later_is_found(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party first(world.join(Role::kWorker));
  meet(coordinator, first);
  for (int i = 0; i < 20; ++i) deliver(coordinator, first, Command{});
  Party second(world.join(Role::kWorker));
  meet(coordinator, second);
  deliver(coordinator, second, batch(7, 100));
  require(second.until([&] { return second.messages() > 0; }), "nothing came");
  second.listen(kQuiet);
  require(second.messages() == 1 && second.received<TaskBatch>().size() == 1,
          "a late joiner was given what was for others");
}

void nobody_is_published_to(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  require(coordinator.bus->publish(EndpointId{12345}, Command{}) == Published::kNoPeer,
          "somebody who is not there was published to");
  require(coordinator.bus->publish(EndpointId{}, Command{}) == Published::kNoPeer,
          "nobody was published to");
}

void a_stranger_of_another_version_is_heard(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party stranger(world.join(Role::kWorker, kProtocol + 1));
  Announcement hello;
  hello.protocol = kProtocol + 1;
  require(coordinator.until([&] {
    stranger.take_all();
    stranger.bus->publish(EndpointId{}, hello);
    return !coordinator.received<Announcement>().empty();
  }),
          "the announcement of another version never came");
  require(coordinator.received<Announcement>().front() == hello, "the announcement was changed");
  require(coordinator.events.front().peer == stranger.bus->self(), "it came from somebody else");
  require(!coordinator.sees(stranger) && !stranger.sees(coordinator),
          "peers of different versions see each other");
}

void messages_come_after_their_sender_appeared(World& world) {
  // Whoever is seen first is sent to at once.
  for (int round = 0; round < 3; ++round) {
    Party coordinator(world.join(Role::kCoordinator));
    Party worker(world.join(Role::kWorker));
    require(coordinator.until([&] { return coordinator.sees(worker); }), "a peer never appeared");
    for (int i = 0; i < 3; ++i) coordinator.bus->publish(worker.bus->self(), Command{});
    require(worker.until([&] { return worker.messages() == 3; }), "nothing came");
    require(std::holds_alternative<PeerAppeared>(worker.events.front().what),
            "a message came before its sender appeared");
  }
}

// ---- Messages ----

void every_kind_arrives_as_it_was(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  for (const Message& message : sample_messages()) {
    const bool outwards = sender_of(message) == Role::kCoordinator;
    Party& from = outwards ? coordinator : worker;
    Party& to = outwards ? worker : coordinator;
    to.events.clear();
    deliver(from, to, message);
    require(to.until([&] { return to.messages() > 0; }), "a message never came");
    require(to.messages() == 1, "a message came more than once");
    require(std::get<Message>(to.events.front().what) == message, "a message was changed");
    require(to.events.front().peer == from.bus->self(), "a message came from somebody else");
  }
}

void messages_of_a_kind_keep_their_order(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  constexpr std::uint32_t kMany = 500;
  for (std::uint32_t i = 0; i < kMany; ++i) deliver(worker, coordinator, heartbeat(i));
  coordinator.until([&] { return coordinator.messages() >= kMany; });
  coordinator.listen(kQuiet);
  const auto received = coordinator.received<Heartbeat>();
  require(received.size() == kMany, "not every message came, each once");
  for (std::uint32_t i = 0; i < kMany; ++i) {
    require(received[i].idle_threads == i, "messages came out of order");
  }
}

void only_who_is_addressed_receives(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party first(world.join(Role::kWorker));
  Party second(world.join(Role::kWorker));
  meet(coordinator, first);
  meet(coordinator, second);
  for (std::uint64_t i = 0; i < 50; ++i)
    deliver(coordinator, i % 5 == 0 ? second : first, batch(i, 10));
  first.until([&] { return first.messages() >= 40; });
  second.until([&] { return second.messages() >= 10; });
  first.listen(kQuiet);
  second.listen(kQuiet);
  require(first.messages() == 40 && second.messages() == 10, "messages went to somebody else");
  for (const TaskBatch& one : second.received<TaskBatch>()) {
    require(one.tasks.front().key.task % 5 == 0, "messages went to somebody else");
  }
}

void two_coordinators_are_told_apart(World& world) {
  Party first(world.join(Role::kCoordinator));
  Party second(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(first, worker);
  meet(second, worker);
  deliver(worker, first, heartbeat(1));
  deliver(worker, second, heartbeat(2));
  require(first.until([&] { return first.messages() > 0; }), "nothing came");
  require(second.until([&] { return second.messages() > 0; }), "nothing came");
  first.listen(kQuiet);
  second.listen(kQuiet);
  require(first.received<Heartbeat>() == std::vector{heartbeat(1)}, "the wrong messages came");
  require(second.received<Heartbeat>() == std::vector{heartbeat(2)}, "the wrong messages came");
}

void large_messages_arrive_whole(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  for (const std::size_t bytes : {std::size_t{1000}, std::size_t{70'000}, kTaskBytes / 4}) {
    TaskBatch large = batch(bytes, bytes);
    for (std::size_t i = 0; i < bytes; ++i) {
      large.tasks[0].subproblem[i] = static_cast<std::uint8_t>(i * 2654435761U >> 13U);
    }
    worker.events.clear();
    deliver(coordinator, worker, large);
    require(worker.until([&] { return worker.messages() > 0; }), "a large message never came");
    require(worker.received<TaskBatch>().front() == large, "a large message was changed");
  }
}

void a_scene_arrives_in_pieces(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  Bytes scene(20'000'000);
  for (std::size_t i = 0; i < scene.size(); ++i) {
    scene[i] = static_cast<std::uint8_t>(i * 2654435761U >> 11U);
  }
  const SceneHash hash = hash_of(scene);
  SceneAssembly assembly(hash);
  const auto take_pieces = [&] {
    worker.take_all();
    for (const ScenePiece& piece : worker.received<ScenePiece>()) assembly.add(piece);
    worker.events.clear();
    return assembly.complete();
  };
  for (std::uint64_t offset = 0; offset < scene.size();) {
    const ScenePiece piece = piece_of(scene, hash, offset);
    deliver(coordinator, worker, piece);
    offset += piece.data.size();
    take_pieces();
  }
  require(worker.until(take_pieces), "the scene never came whole");
  require(assembly.take() == scene, "the scene was changed");
}

// ---- Limits ----

void who_does_not_take_is_not_sent_more(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  std::uint64_t sent = 0;
  Published outcome = Published::kSent;
  for (; sent < 20'000 && outcome == Published::kSent; ++sent) {
    const auto begin = std::chrono::steady_clock::now();
    outcome = coordinator.bus->publish(worker.bus->self(), batch(sent, 2000));
    require(std::chrono::steady_clock::now() - begin < 1s, "publishing blocked");
  }
  require(outcome == Published::kFull, "any number of messages can be on their way");
  --sent;
  require(coordinator.bus->counters().full > 0, "it was not counted");
  // What was sent comes all the same, and then there is room again.
  require(worker.until([&] { return worker.messages() >= sent; }), "what was sent never came");
  deliver(coordinator, worker, batch(sent, 2000));
  require(worker.until([&] { return worker.messages() > sent; }), "what was sent never came");
  const auto received = worker.received<TaskBatch>();
  for (std::uint64_t i = 0; i <= sent; ++i) {
    require(received[i].tasks.front().key.task == i, "messages were lost or out of order");
  }
}

void a_full_worker_holds_nobody_up(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party deaf(world.join(Role::kWorker));
  Party keen(world.join(Role::kWorker));
  meet(coordinator, deaf);
  meet(coordinator, keen);
  Published outcome = Published::kSent;
  for (std::uint64_t i = 0; i < 20'000 && outcome == Published::kSent; ++i) {
    outcome = coordinator.bus->publish(deaf.bus->self(), batch(i, 2000));
  }
  require(outcome == Published::kFull, "any number of messages can be on their way");
  require(coordinator.bus->publish(keen.bus->self(), batch(1, 2000)) == Published::kSent,
          "one worker's queue fills another's");
  require(coordinator.bus->publish(deaf.bus->self(), Command{}) == Published::kSent,
          "tasks fill the queue of commands");
  require(keen.until([&] { return keen.messages() == 1; }), "nothing came");
}

void what_is_too_large_or_not_its_to_say_is_refused(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  Party worker(world.join(Role::kWorker));
  meet(coordinator, worker);
  const auto publish = [&](const Message& message) {
    return coordinator.bus->publish(worker.bus->self(), message);
  };
  require(publish(batch(0, kTaskBytes + 1)) == Published::kInvalid, "a huge task was sent");
  TaskBatch many;
  many.tasks.resize(kBatchItems + 1);
  require(publish(many) == Published::kInvalid, "a huge batch was sent");
  require(publish(Heartbeat{}) == Published::kInvalid, "a coordinator sent a worker's message");
}

// ---- Waiting ----

void waiting_ends(World& world) {
  Party coordinator(world.join(Role::kCoordinator));
  coordinator.listen(kQuiet);
  require(!coordinator.bus->wait_for_event(1ms), "something was promised and nothing came");
  coordinator.bus->wake();
  const auto begin = std::chrono::steady_clock::now();
  coordinator.bus->wait_for_event(10s);
  std::thread other([&] { coordinator.bus->wake(); });
  coordinator.bus->wait_for_event(10s);
  other.join();
  require(std::chrono::steady_clock::now() - begin < 5s, "waking did not end the wait");
}

// Runs a check that says what is broken by throwing.
Check check(std::string name, void (*run)(World&)) {
  return {std::move(name), [run](World& world) -> Breach {
            try {
              run(world);
            } catch (const std::runtime_error& found) {
              return found.what();
            }
            return {};
          }};
}

}  // namespace

const std::vector<Check>& checks() {
  static const std::vector<Check> all{
      check("PeersFindEachOther", peers_find_each_other),
      check("WhoLeavesIsLost", who_leaves_is_lost),
      check("WhoComesLaterIsFound", who_comes_later_is_found),
      check("NobodyIsPublishedTo", nobody_is_published_to),
      check("AStrangerOfAnotherVersionIsHeard", a_stranger_of_another_version_is_heard),
      check("MessagesComeAfterTheirSenderAppeared", messages_come_after_their_sender_appeared),
      check("EveryKindArrivesAsItWas", every_kind_arrives_as_it_was),
      check("MessagesOfAKindKeepTheirOrder", messages_of_a_kind_keep_their_order),
      check("OnlyWhoIsAddressedReceives", only_who_is_addressed_receives),
      check("TwoCoordinatorsAreToldApart", two_coordinators_are_told_apart),
      check("LargeMessagesArriveWhole", large_messages_arrive_whole),
      check("ASceneArrivesInPieces", a_scene_arrives_in_pieces),
      check("WhoDoesNotTakeIsNotSentMore", who_does_not_take_is_not_sent_more),
      check("AFullWorkerHoldsNobodyUp", a_full_worker_holds_nobody_up),
      check("WhatIsTooLargeOrNotItsToSayIsRefused", what_is_too_large_or_not_its_to_say_is_refused),
      check("WaitingEnds", waiting_ends),
  };
  return all;
}

const Check& check_named(const std::string& name) {
  return *std::ranges::find(checks(), name, &Check::name);
}

std::vector<Message> sample_messages() {
  SceneHash hash;
  for (std::size_t i = 0; i < hash.bytes.size(); ++i) hash.bytes[i] = static_cast<std::uint8_t>(i);
  Announcement announcement;
  announcement.version = "0.1.0";
  announcement.host = "h\xc3\xb6st";
  announcement.process = 4711;
  announcement.threads = 16;
  announcement.task_bytes = 1ULL << 40U;
  announcement.scene_bytes = 5;
  announcement.leaving = true;
  const TaskKey key{0xfedcba9876543210ULL, 77};
  return {
      TaskBatch{9, hash, {1, 2, 3}, {{key, {0, 255, 0}}, {{2, 1}, {}}}},
      TaskBatch{},
      Command{Command::Kind::kRefuse, {key, {1, 2}}, hash, "too old"},
      Command{Command::Kind::kForget, {}, hash, {}},
      ScenePiece{hash, 1000, 990, Bytes(10, 42)},
      announcement,
      ResultBatch{{{key, ResultItem::Outcome::kDone, {5, 6}, 0.125, {}},
                   {{1, 0}, ResultItem::Outcome::kRefused, {}, -0.0, "tasks[0].start: expected"}}},
      Heartbeat{3, {{key, true, 1.5}, {{8, 0}, false, 0}}},
      SceneRequest{hash, 262'144},
  };
}

}  // namespace accord::bus_contract
