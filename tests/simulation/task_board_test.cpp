// The coordinator's books in clusters that suffer: a scripted worker's "solution" of a task is its
// payload reversed, so that everything that comes back can be checked.
#include "coordinator/dispatch/task_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <map>

#include "common/planning/random.h"
#include "common/transport/simulated_network.h"

namespace accord {
namespace {

using std::chrono::milliseconds;
using Time = Bus::Duration;

Bytes payload_of(TaskId task) {
  Bytes bytes;
  for (TaskId rest = task + 1; rest > 0; rest /= 7) {
    bytes.push_back(static_cast<Bytes::value_type>(rest % 7));
  }
  return bytes;
}

Bytes solution_of(Bytes payload) {
  std::ranges::reverse(payload);
  return payload;
}

// One process that works: takes what it is given, one task at a time.
class ScriptedWorker {
 public:
  ScriptedWorker(SimulatedNetwork& network, Time task_time, TaskId poison)
      : bus_(network.join(Role::kWorker)), task_time_(task_time), poison_(poison) {}

  EndpointId id() const { return bus_->self(); }
  bool lies = false;   // what it returns does not hold
  bool fails = false;  // it runs into trouble of its own
  bool dead = false;

  void step(Time now) {
    while (const auto event = bus_->take()) on_event(*event, now);
    if (coordinator_ && now - heard_ >= milliseconds(400)) coordinator_.reset();
    if (now >= speak_at_) {
      if (coordinator_) {
        say_alive(now);
      } else {
        announce();
      }
      speak_at_ = now + milliseconds(100);
    }
    while (!tasks_.empty() && now >= done_at_) finish(now);
  }
  Time next() const { return tasks_.empty() ? speak_at_ : std::min(speak_at_, done_at_); }
  // Has it a task in hand that nobody survives?
  bool is_poisoned() const { return !tasks_.empty() && tasks_.front().key.task == poison_; }

 private:
  void on_event(const BusEvent& event, Time now) {
    if (std::holds_alternative<PeerLost>(event.what)) {
      if (coordinator_ == event.peer) coordinator_.reset();
      return;
    }
    if (std::holds_alternative<PeerAppeared>(event.what)) speak_at_ = now;
    const auto* message = std::get_if<Message>(&event.what);
    if (message == nullptr) return;
    heard_ = now;
    if (const auto* command = std::get_if<Command>(message)) {
      if (command->kind == Command::Kind::kWelcome) coordinator_ = event.peer;
      for (const TaskKey& key : command->tasks) {
        std::erase_if(tasks_, [&](const TaskItem& item) { return item.key == key; });
      }
    }
    if (const auto* batch = std::get_if<TaskBatch>(message)) {
      for (const TaskItem& item : batch->tasks) {
        if (tasks_.empty()) done_at_ = now + task_time_;
        tasks_.push_back(item);
      }
    }
  }
  void announce() {
    Announcement announcement;
    announcement.threads = 1;
    announcement.task_bytes = 1 << 20;
    bus_->publish({}, announcement);
  }
  void say_alive(Time) {
    Heartbeat heartbeat;
    for (const TaskItem& item : tasks_) {
      heartbeat.tasks.push_back({item.key, item.key == tasks_.front().key, 0});
    }
    bus_->publish(*coordinator_, heartbeat);
  }
  void finish(Time now) {
    ResultItem result;
    result.key = tasks_.front().key;
    result.resolution = lies ? Bytes(3, 99) : solution_of(tasks_.front().subproblem);
    result.seconds = std::chrono::duration<double>(task_time_).count();
    if (fails) {
      result.outcome = ResultItem::Outcome::kFailed;
      result.text = "no memory";
      result.resolution.clear();
    }
    if (coordinator_ && bus_->publish(*coordinator_, ResultBatch{{result}}) == Published::kFull) {
      done_at_ = now + milliseconds(1);
      return;
    }
    tasks_.pop_front();
    done_at_ = now + task_time_;
  }

  std::unique_ptr<Bus> bus_;
  Time task_time_;
  TaskId poison_;
  std::optional<EndpointId> coordinator_;
  Time heard_{0}, speak_at_{0}, done_at_{0};
  std::deque<TaskItem> tasks_;
};

constexpr TaskId kNoPoison = 1'000'000;

class Cluster {
 public:
  explicit Cluster(std::uint64_t seed, TaskId poison = kNoPoison)
      : network_(seed), random_(seed), poison_(poison), bus_(network_.join(Role::kCoordinator)) {}

  ScriptedWorker& start_worker(Time task_time) {
    workers_.push_back(std::make_unique<ScriptedWorker>(network_, task_time, poison_));
    return *workers_.back();
  }
  void submit(TaskId first, std::size_t count) {
    RequestWork work;
    work.request = first;
    std::vector<NewTask> tasks;
    for (TaskId id = first; id < first + count; ++id) {
      tasks.push_back({id, {}, payload_of(id), 1 + static_cast<double>(id % 5)});
    }
    board.add(std::move(work), std::move(tasks));
  }

  // Runs until nothing is unfinished; false: not within the time.
  bool run(Time until) {
    while (board.unfinished() > 0) {
      if (network_.now() > until) return false;
      step();
    }
    take_finished();
    return true;
  }

  void step() {
    const Time now = network_.now();
    while (const auto event = bus_->take()) board.on_event(*event, now);
    board.on_time(now);
    take_finished();
    while (const auto out = board.next_outgoing(now)) {
      board.on_published(out->to, bus_->publish(out->to, out->message), now);
    }
    for (const auto& worker : workers_) {
      if (worker->dead) continue;
      worker->step(now);
      if (worker->is_poisoned()) kill(*worker);
    }
    Time next = now + milliseconds(5);
    if (const auto due = network_.next()) next = std::min(next, std::max(*due, now));
    if (const auto due = board.next_deadline()) next = std::min(next, std::max(*due, now));
    for (const auto& worker : workers_) {
      if (!worker->dead) next = std::min(next, std::max(worker->next(), now));
    }
    network_.advance_to(std::max(next, now + std::chrono::microseconds(10)));
  }

  void take_finished() {
    while (const auto finished = board.take_finished()) {
      if (finished->how != FinishedTask::How::kDone) {
        not_done[finished->task] = *finished;
      } else if (finished->resolution != solution_of(payload_of(finished->task))) {
        board.reject(*finished, "it does not hold");
        ++rejected;
      } else {
        EXPECT_TRUE(done.insert(finished->task).second) << "finished twice";
        if (on_done) on_done(finished->task, finished->worker);
        board.accept(finished->task);
      }
    }
  }

  void kill(ScriptedWorker& worker) {
    worker.dead = true;
    network_.kill(worker.id());
  }
  // A fault, or none.
  void strike() {
    const auto victim = static_cast<std::size_t>(random_.below(workers_.size()));
    switch (random_.below(8)) {
      case 0:
        if (!workers_[victim]->dead) kill(*workers_[victim]);
        start_worker(milliseconds(1 + random_.below(20)));
        break;
      case 1:
        network_.cut(bus_->self(), workers_[victim]->id());
        break;
      case 2:
        network_.heal(bus_->self(), workers_[victim]->id());
        break;
      case 3:
        network_.set_faults({0.2, 0.1, 0.2});
        break;
      case 4:
        network_.set_faults({});
        break;
      default:
        break;
    }
  }
  void calm() {
    network_.set_faults({});
    for (const auto& worker : workers_) network_.heal(bus_->self(), worker->id());
  }

  TaskBoard board{TaskBoard::Settings{}};
  std::function<void(TaskId, EndpointId)> on_done;
  int rejected = 0;
  std::set<TaskId> done;
  std::map<TaskId, FinishedTask> not_done;
  SimulatedNetwork& network() { return network_; }

 private:
  SimulatedNetwork network_;
  RandomStream random_;
  TaskId poison_;
  std::unique_ptr<Bus> bus_;
  std::vector<std::unique_ptr<ScriptedWorker>> workers_;
};

TEST(TaskBoard, GetsEveryTaskDoneOnce) {
  Cluster cluster(1);
  for (int i = 0; i < 3; ++i) cluster.start_worker(milliseconds(2));
  cluster.submit(1, 200);
  EXPECT_TRUE(cluster.run(std::chrono::seconds(5)));
  EXPECT_EQ(cluster.done.size(), 200U);
  EXPECT_EQ(cluster.board.counters().reassigned(), 0U);
}

TEST(TaskBoard, KeepsAllWorkersBusy) {
  for (const int workers : {1, 4, 16}) {
    Cluster cluster(2);
    for (int i = 0; i < workers; ++i) cluster.start_worker(milliseconds(4));
    cluster.submit(1, 320);
    ASSERT_TRUE(cluster.run(std::chrono::seconds(60)));
    const double ideal = 320 * 0.004 / workers;
    EXPECT_LT(std::chrono::duration<double>(cluster.network().now()).count(), 1.2 * ideal + 0.05)
        << workers << " workers";
  }
}

TEST(TaskBoard, GivesTasksOfTheDeadToOthers) {
  Cluster cluster(3);
  ScriptedWorker& first = cluster.start_worker(milliseconds(10));
  cluster.submit(1, 20);
  while (cluster.network().now() < milliseconds(60)) cluster.step();
  cluster.kill(first);
  cluster.start_worker(milliseconds(10));
  EXPECT_TRUE(cluster.run(std::chrono::seconds(10)));
  EXPECT_EQ(cluster.board.counters().workers_lost(), 1U);
  EXPECT_GT(cluster.board.counters().reassigned(), 0U);
}

TEST(TaskBoard, QuarantinesATaskThatKillsThreeWorkers) {
  constexpr TaskId kPoison = 7;
  Cluster cluster(4, kPoison);
  for (int i = 0; i < 8; ++i) cluster.start_worker(milliseconds(3));
  cluster.submit(1, 30);
  EXPECT_TRUE(cluster.run(std::chrono::seconds(30)));
  EXPECT_EQ(cluster.done.size(), 29U);
  ASSERT_EQ(cluster.not_done.size(), 1U);
  EXPECT_EQ(cluster.not_done.begin()->first, kPoison);
  EXPECT_EQ(cluster.not_done.begin()->second.how, FinishedTask::How::kQuarantined);
  EXPECT_EQ(cluster.board.counters().workers_lost(), 3U);
}

TEST(TaskBoard, DistrustsWhoeverReturnsWhatDoesNotHold) {
  Cluster cluster(5);
  ScriptedWorker& liar = cluster.start_worker(milliseconds(1));
  liar.lies = true;
  cluster.start_worker(milliseconds(5));
  cluster.submit(1, 40);
  EXPECT_TRUE(cluster.run(std::chrono::seconds(10)));
  EXPECT_EQ(cluster.done.size(), 40U);
  EXPECT_EQ(cluster.rejected, 1) << "it is not asked again";
  EXPECT_EQ(cluster.board.workers().at(liar.id()).standing, WorkerRecord::Standing::kDistrusted);
}

TEST(TaskBoard, AsksOthersWhereAWorkerFails) {
  Cluster cluster(6);
  cluster.start_worker(milliseconds(1)).fails = true;
  cluster.start_worker(milliseconds(5));
  cluster.submit(1, 10);
  EXPECT_TRUE(cluster.run(std::chrono::seconds(10)));
  EXPECT_EQ(cluster.done.size(), 10U);
}

TEST(TaskBoard, SaysWhyNobodyTakesATask) {
  Cluster cluster(7);
  cluster.start_worker(milliseconds(1)).fails = true;
  cluster.submit(1, 1);
  EXPECT_TRUE(cluster.run(std::chrono::seconds(10)));
  ASSERT_EQ(cluster.not_done.size(), 1U);
  EXPECT_EQ(cluster.not_done.begin()->second.how, FinishedTask::How::kRefused);
  EXPECT_NE(cluster.not_done.begin()->second.text.find("no memory"), std::string::npos);
}

TEST(TaskBoard, DropsWhatHasEnded) {
  Cluster cluster(8);
  cluster.start_worker(milliseconds(5));
  cluster.submit(1, 50);
  cluster.submit(1000, 5);
  while (cluster.network().now() < milliseconds(40)) cluster.step();
  cluster.board.end(1);
  EXPECT_LE(cluster.board.unfinished(), 5U);
  cluster.done.clear();
  EXPECT_TRUE(cluster.run(std::chrono::seconds(5)));
  for (const TaskId task : cluster.done) EXPECT_GE(task, 1000U);
}

// Two workers, 20 pairs of robots that stand beside each other, and three rounds: each robot's
// path, then what each pair has to settle, twice.
TEST(TaskBoard, GivesTasksToThoseWhoHaveTheirRoadmaps) {
  constexpr RoadmapPlace kPairs = 20;
  Cluster cluster(9);
  std::map<EndpointId, std::set<RoadmapPlace>> built;
  for (int i = 0; i < 2; ++i) cluster.start_worker(milliseconds(4));
  std::map<TaskId, std::vector<RoadmapPlace>> needs;
  cluster.on_done = [&](TaskId task, EndpointId worker) {
    built[worker].insert(needs.at(task).begin(), needs.at(task).end());
  };
  const auto built_twice = [&] {
    std::size_t all = 0;
    for (const auto& [worker, places] : built) all += places.size();
    return all - 2 * kPairs;
  };
  RequestWork work;
  work.request = 1;
  for (RoadmapPlace place = 0; place < 2 * kPairs; ++place) work.partners.push_back(place ^ 1U);
  std::vector<NewTask> paths;
  TaskId id = 1;
  for (RoadmapPlace place = 0; place < 2 * kPairs; ++place, ++id) {
    needs[id] = {place};
    paths.push_back({id, {}, payload_of(id), 10, false, needs[id]});
  }
  cluster.board.add(std::move(work), std::move(paths));
  ASSERT_TRUE(cluster.run(std::chrono::seconds(10)));
  EXPECT_EQ(built_twice(), 0U);
  for (int round = 0; round < 2; ++round) {
    std::vector<NewTask> pairs;
    for (RoadmapPlace pair = 0; pair < kPairs; ++pair, ++id) {
      needs[id] = {2 * pair, 2 * pair + 1};
      pairs.push_back({id, {}, payload_of(id), 10, false, needs[id]});
    }
    cluster.board.add(1, std::move(pairs));
    ASSERT_TRUE(cluster.run(std::chrono::seconds(10)));
  }
  EXPECT_LE(built_twice(), 4U) << "who would idle takes another's";
}

// A worker that had lost its task, and was given it again, answers the first time after all.
TEST(TaskBoard, DropsWhatWasSaidOfAFormerEpoch) {
  constexpr EndpointId kWorker{7};
  TaskBoard board{TaskBoard::Settings{}};
  Announcement announcement;
  announcement.threads = 1;
  announcement.task_bytes = 100;
  board.on_event({kWorker, Message(announcement)}, Time(0));
  RequestWork work;
  work.request = 1;
  board.add(std::move(work), {{5, {}, payload_of(5), 1}});
  const auto send_all = [&](Time now) {
    std::optional<TaskKey> assigned;
    while (const auto out = board.next_outgoing(now)) {
      if (const auto* batch = std::get_if<TaskBatch>(&out->message)) assigned = batch->tasks[0].key;
      board.on_published(out->to, Published::kSent, now);
    }
    return assigned;
  };
  const auto first = send_all(Time(0));
  ASSERT_TRUE(first);
  for (int beat = 2; beat < 6; ++beat) {  // heartbeats that name no task
    board.on_event({kWorker, Message(Heartbeat{})}, milliseconds(100 * beat));
  }
  const auto second = send_all(milliseconds(600));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->task, first->task);
  EXPECT_GT(second->epoch, first->epoch);

  ResultItem late;
  late.key = *first;
  board.on_event({kWorker, Message(ResultBatch{{late}})}, milliseconds(610));
  EXPECT_FALSE(board.take_finished());
  EXPECT_EQ(board.counters().late, 1U);
  EXPECT_EQ(board.counters().reassigned(Reassigned::kUnheard), 1U);
  late.key = *second;
  board.on_event({kWorker, Message(ResultBatch{{late}})}, milliseconds(620));
  EXPECT_TRUE(board.take_finished());
  board.on_event({kWorker, Message(ResultBatch{{late}})}, milliseconds(630));
  EXPECT_FALSE(board.take_finished());
  EXPECT_EQ(board.counters().duplicate, 1U);
  EXPECT_EQ(board.counters().late, 1U);
}

// A board and its workers, whose every word is the test's.
class Scripted {
 public:
  static constexpr RequestId kRequest = 1;

  explicit Scripted(std::vector<std::uint32_t> threads) {
    for (std::uint32_t i = 0; i < threads.size(); ++i) {
      Announcement announcement;
      announcement.threads = threads[i];
      announcement.task_bytes = 100;
      board.on_event({EndpointId{i + 1}, Message(announcement)}, Time(0));
    }
    RequestWork work;
    work.request = kRequest;
    board.add(std::move(work), {});
    send();
  }

  void add(TaskId id, bool is_ahead, Bytes hierarchy = {}) {
    // Heavy: nothing is sent in advance.
    board.add(kRequest, {{id, std::move(hierarchy), payload_of(id), 1e6, is_ahead}});
    send();
  }

  void send() {
    while (const auto out = board.next_outgoing(Time(0))) {
      if (const auto* batch = std::get_if<TaskBatch>(&out->message)) {
        batches.push_back(*batch);
        for (const TaskItem& item : batch->tasks) in_hand[item.key.task] = {out->to, item.key};
      }
      if (const auto* command = std::get_if<Command>(&out->message)) {
        for (const TaskKey& key : command->tasks) {
          if (in_hand.contains(key.task) && in_hand[key.task].second == key) {
            in_hand.erase(key.task);
          }
        }
      }
      board.on_published(out->to, Published::kSent, Time(0));
    }
  }

  void finish(TaskId id) {
    const auto [worker, key] = in_hand.at(id);
    ResultItem result;
    result.key = key;
    result.seconds = 0.25;
    board.on_event({worker, Message(ResultBatch{{result}})}, Time(0));
    in_hand.erase(id);
    send();
  }

  std::set<TaskId> tasks_in_hand() const {
    std::set<TaskId> out;
    for (const auto& [id, where] : in_hand) out.insert(id);
    return out;
  }

  TaskBoard board{TaskBoard::Settings{}};
  std::vector<TaskBatch> batches;
  std::map<TaskId, std::pair<EndpointId, TaskKey>> in_hand;
};

using Tasks = std::set<TaskId>;

TEST(TaskBoard, GivesWhatIsAheadOfNeedToIdleThreadsOnlyInItsOrder) {
  Scripted cluster({2});
  EXPECT_EQ(cluster.board.threads(), 2U);
  cluster.add(1, false);
  cluster.add(2, true);
  cluster.add(3, true);
  EXPECT_EQ(cluster.tasks_in_hand(), (Tasks{1, 2}));
  cluster.finish(2);
  EXPECT_EQ(cluster.tasks_in_hand(), (Tasks{1, 3}));
}

TEST(TaskBoard, TakesBackWhatIsAheadOfNeedWhereOthersWouldWait) {
  Scripted cluster({1, 1});
  cluster.add(1, true);
  cluster.add(2, true);
  cluster.add(3, false);
  EXPECT_TRUE(cluster.tasks_in_hand().contains(3));
  EXPECT_EQ(cluster.tasks_in_hand().size(), 2U) << "one of them makes way, the other need not";
  cluster.add(4, false);
  EXPECT_EQ(cluster.tasks_in_hand(), (Tasks{3, 4}));
  EXPECT_EQ(cluster.board.counters().put_off, 2U);
  cluster.finish(3);
  EXPECT_EQ(cluster.tasks_in_hand(), (Tasks{1, 4})) << "and is begun again";
}

TEST(TaskBoard, CountsAResultThatCrossesItsRevocationAsMootNotLate) {
  Scripted cluster({1});
  cluster.add(1, true);
  const auto [worker, key] = cluster.in_hand.at(1);
  cluster.add(2, false);  // task 1 makes way
  ResultItem result;
  result.key = key;
  cluster.board.on_event({worker, Message(ResultBatch{{result}})}, Time(0));
  cluster.board.cancel({2});
  EXPECT_EQ(cluster.board.counters().moot, 1U);
  EXPECT_EQ(cluster.board.counters().late, 0U);
  EXPECT_EQ(cluster.board.counters().cancelled, 1U);
}

TEST(TaskBoard, TellsWorkersThatLeaveInOrderFromThoseThatAreLost) {
  Scripted cluster({1, 1, 1});
  Announcement leaving;
  leaving.leaving = true;
  leaving.threads = 1;
  cluster.board.on_event({EndpointId{1}, Message(leaving)}, Time(0));
  EXPECT_EQ(cluster.board.load(Time(0)).workers.at(WorkerRecord::Standing::kLeaving), 1U);
  cluster.board.on_event({EndpointId{1}, PeerLost{}}, Time(0));
  cluster.board.on_event({EndpointId{2}, PeerLost{}}, Time(0));
  cluster.board.on_time(std::chrono::hours(1));
  const BoardCounters& counters = cluster.board.counters();
  EXPECT_EQ(counters.workers_left, 1U);
  EXPECT_EQ(counters.workers_gone, 1U);
  EXPECT_EQ(counters.workers_silent, 1U);
  EXPECT_EQ(counters.workers_lost(), 2U);
}

TEST(TaskBoard, MeasuresHowLongTasksWaitAndHowBusyThreadsAre) {
  TaskBoard board{TaskBoard::Settings{}};
  RequestWork work;
  work.request = 1;
  board.add(std::move(work), {{1, {}, payload_of(1), 1}, {2, {}, payload_of(2), 1e6}});
  EXPECT_FALSE(board.next_outgoing(Time(0)));
  EXPECT_EQ(board.load(milliseconds(300)).waiting, 2U);
  EXPECT_EQ(board.load(milliseconds(300)).oldest, milliseconds(300));

  const EndpointId worker{1};
  Announcement announcement;
  announcement.threads = 2;
  announcement.task_bytes = 100;
  board.on_event({worker, Message(announcement)}, milliseconds(500));
  while (const auto out = board.next_outgoing(milliseconds(500))) {
    board.on_published(out->to, Published::kSent, milliseconds(500));
  }
  EXPECT_EQ(board.counters().waited.total(), 2U);
  EXPECT_DOUBLE_EQ(board.counters().waited.sum, 1.0);

  Heartbeat heartbeat;
  heartbeat.idle_threads = 1;
  board.on_event({worker, Message(heartbeat)}, milliseconds(600));
  board.on_event({worker, Message(heartbeat)}, milliseconds(800));
  EXPECT_DOUBLE_EQ(board.counters().thread_seconds, 0.4);
  EXPECT_DOUBLE_EQ(board.counters().busy_seconds, 0.2);
  const TaskBoard::Load load = board.load(milliseconds(800));
  EXPECT_EQ(load.assigned, 2U);
  EXPECT_EQ(load.oldest, Time(0));
  EXPECT_EQ(load.threads, 2U);
  EXPECT_EQ(load.busy, 1U);
}

TEST(TaskBoard, KeepsWhatWasHurried) {
  Scripted cluster({1});
  cluster.add(1, true);
  cluster.board.hurry({1});
  cluster.add(2, false);
  EXPECT_TRUE(cluster.tasks_in_hand().contains(1));
  EXPECT_EQ(cluster.board.counters().put_off, 0U);
}

TEST(TaskBoard, GivesUpWhatIsAheadOfNeedWhenItHasKilledOneWorker) {
  Scripted cluster({1, 1});
  cluster.add(1, true);
  cluster.board.on_event({cluster.in_hand.at(1).first, PeerLost{}}, Time(0));
  cluster.send();
  const auto finished = cluster.board.take_finished();
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->how, FinishedTask::How::kQuarantined);
  EXPECT_EQ(cluster.board.threads(), 1U);
}

TEST(TaskBoard, DropsWhatIsCancelledWhereverItIs) {
  Scripted cluster({1});
  cluster.add(1, false);
  cluster.finish(1);      // finished, and not taken
  cluster.add(2, false);  // in hand
  cluster.add(3, true);   // waits
  EXPECT_EQ(cluster.board.unfinished(), 2U);
  cluster.board.cancel({1, 2, 3, 99});
  cluster.send();
  EXPECT_EQ(cluster.board.unfinished(), 0U);
  EXPECT_TRUE(cluster.in_hand.empty()) << "it was not told to stop";
  EXPECT_FALSE(cluster.board.take_finished());
}

TEST(TaskBoard, SaysHowLongATaskTook) {
  Scripted cluster({1});
  cluster.add(1, false);
  cluster.finish(1);
  EXPECT_EQ(cluster.board.take_finished()->seconds, 0.25);
}

// What a batch says of its hierarchy holds for all its tasks.
TEST(TaskBoard, BatchesTasksOfTheSameHierarchyOnly) {
  Scripted cluster({1});
  std::vector<NewTask> tasks;
  for (TaskId id = 1; id <= 9; ++id) {
    tasks.push_back({id, Bytes(1, id % 2 == 0), payload_of(id), 1e-3});
  }
  cluster.board.add(Scripted::kRequest, std::move(tasks));
  cluster.send();
  for (const TaskBatch& batch : cluster.batches) {
    for (const TaskItem& item : batch.tasks) {
      EXPECT_EQ(batch.hierarchy, Bytes(1, item.key.task % 2 == 0));
    }
  }
  EXPECT_EQ(cluster.tasks_in_hand().size(), 9U);
}

TEST(TaskBoard, SendsTheSceneThatWasAskedForLastFromItsBeginning) {
  constexpr EndpointId kWorker{7};
  TaskBoard board{TaskBoard::Settings{}};
  Announcement announcement;
  announcement.threads = 1;
  board.on_event({kWorker, Message(announcement)}, Time(0));
  SceneHash hashes[2];
  for (std::uint8_t i = 0; i < 2; ++i) {
    RequestWork work;
    work.request = i;
    hashes[i].bytes[0] = i;
    work.scene = hashes[i];
    work.scene_bytes = std::make_shared<const Bytes>(100, i);
    board.add(std::move(work), {});
  }
  board.on_event({kWorker, Message(SceneRequest{hashes[0], 0})}, Time(0));
  bool asked = false;
  std::vector<ScenePiece> sent;
  while (const auto out = board.next_outgoing(Time(0))) {
    if (const auto* piece = std::get_if<ScenePiece>(&out->message)) {
      sent.push_back(*piece);
      // Asks for the other one while the first is on its way.
      if (!asked) board.on_event({kWorker, Message(SceneRequest{hashes[1], 0})}, Time(0));
      asked = true;
    }
    board.on_published(out->to, Published::kSent, Time(0));
  }
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[1].scene, hashes[1]);
  EXPECT_EQ(sent[1].offset, 0U);
}

TEST(TaskBoard, HasWorkersForgetAllButTheLastScenes) {
  constexpr EndpointId kWorker{7};
  TaskBoard::Settings settings;
  settings.idle_scenes = 2;
  TaskBoard board{settings};
  Announcement announcement;
  announcement.threads = 1;
  board.on_event({kWorker, Message(announcement)}, Time(0));
  std::vector<std::uint8_t> forgotten;
  const auto plan_in = [&](RequestId request, std::uint8_t scene) {
    RequestWork work;
    work.request = request;
    work.scene.bytes[0] = scene;
    work.scene_bytes = std::make_shared<const Bytes>(100, scene);
    const SceneHash hash = work.scene;
    board.add(std::move(work), {});
    board.on_event({kWorker, Message(SceneRequest{hash, 0})}, Time(0));
    board.end(request);
    while (const auto out = board.next_outgoing(Time(0))) {
      const auto* command = std::get_if<Command>(&out->message);
      if (command != nullptr && command->kind == Command::Kind::kForget) {
        forgotten.push_back(command->scene.bytes[0]);
      }
      board.on_published(out->to, Published::kSent, Time(0));
    }
  };
  plan_in(1, 10);
  plan_in(2, 20);
  plan_in(3, 10);  // again: the last that was needed now
  EXPECT_EQ(forgotten, std::vector<std::uint8_t>{});
  plan_in(4, 30);
  EXPECT_EQ(forgotten, std::vector<std::uint8_t>{20});
}

// Kills, cut links, and messages that are lost, come twice or out of order, at random moments.
TEST(TaskBoard, LosesNothingInAThousandClustersThatSuffer) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Cluster cluster(seed);
    RandomStream random(seed);
    for (int i = 0; i < 3; ++i) {
      cluster.start_worker(milliseconds(1 + random.below(10)));
    }
    cluster.submit(1, 40);
    for (int fault = 0; fault < 12; ++fault) {
      const Time until = cluster.network().now() + milliseconds(random.below(300));
      while (cluster.network().now() < until && cluster.board.unfinished() > 0) cluster.step();
      cluster.strike();
    }
    cluster.calm();
    cluster.start_worker(milliseconds(2));
    ASSERT_TRUE(cluster.run(cluster.network().now() + std::chrono::seconds(20))) << seed;
    EXPECT_EQ(cluster.done.size() + cluster.not_done.size(), 40U) << seed;
    for (const auto& [task, finished] : cluster.not_done) {
      EXPECT_EQ(finished.how, FinishedTask::How::kQuarantined) << seed << ": " << finished.text;
    }
  }
}

TEST(TaskBoard, TellsWhoListensWhatBecomesOfTasksAndWorkers) {
  using Kind = BoardNote::Kind;
  struct Told {
    Kind kind;
    EndpointId worker;
    std::string request;
    std::uint64_t task;
    std::uint32_t epoch;
    bool operator==(const Told&) const = default;
  };
  std::vector<Told> told;
  TaskBoard board{TaskBoard::Settings{}};
  board.set_listener([&](const BoardNote& note) {
    const TaskKey key = note.task.value_or(TaskKey{});
    told.push_back({note.kind, note.worker, std::string(note.request), key.task, key.epoch});
  });
  const auto send_all = [&] {
    while (const auto out = board.next_outgoing(Time(0))) {
      board.on_published(out->to, Published::kSent, Time(0));
    }
  };
  const EndpointId first{1}, second{2};
  Announcement announcement;
  announcement.threads = 1;
  announcement.task_bytes = 100;
  board.on_event({first, Message(announcement)}, Time(0));
  board.on_event({first, Message(announcement)}, Time(0));  // says it again
  RequestWork work;
  work.request = 1;
  work.name = "depot-7";
  board.add(std::move(work), {{5, {}, payload_of(5), 1}});
  send_all();
  board.on_event({first, PeerLost{}}, Time(0));
  announcement.protocol = kProtocol + 1;
  board.on_event({second, Message(announcement)}, Time(0));
  EXPECT_EQ(told, (std::vector<Told>{{Kind::kWelcomed, first, "", 0, 0},
                                     {Kind::kAssigned, first, "depot-7", 5, 0},
                                     {Kind::kGone, first, "", 0, 0},
                                     {Kind::kReassigned, first, "depot-7", 5, 0},
                                     {Kind::kRefused, second, "", 0, 0}}));
}

}  // namespace
}  // namespace accord
