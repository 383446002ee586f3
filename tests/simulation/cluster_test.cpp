// Planning by clusters that suffer: workers die, hang, come back, lie, are of another protocol;
// links are cut; messages get lost, come twice or out of order. The plan is the one of a quiet day.
//
// ACCORD_CLUSTERS: how many seeded clusters to run; 150 unless told (the campaign: 1000).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <list>

#include "common/geometry/tolerances.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/planning/random.h"
#include "common/transport/simulated_network.h"
#include "coordinator/dispatch/direct_port.h"
#include "coordinator/dispatch/remote_crew.h"
#include "tests/simulation/lies.h"
#include "tests/support/planned_paths.h"
#include "worker/service/scene_shelf.h"
#include "worker/service/task_desk.h"

namespace accord {
namespace {

using std::chrono::milliseconds;
using Time = Bus::Duration;

TaskDesk::Settings settings_of_a_worker() {
  TaskDesk::Settings settings;
  settings.info.threads = 2;
  settings.info.task_bytes = 1 << 20;
  settings.info.scene_bytes = 1 << 24;
  return settings;
}

// A worker process with its loop and its threads, on the network's clock.
class SimulatedWorker {
 public:
  SimulatedWorker(SimulatedNetwork& network, std::uint64_t seed, std::uint32_t protocol)
      : bus_(network.join(Role::kWorker, protocol)), desk_(settings(protocol)), random_(seed) {}

  EndpointId id() const { return bus_->self(); }
  bool dead = false;
  bool frozen = false;
  std::function<void(const TaskDesk::Job&, Bytes& resolution)> lie;

  void step(Time now) {
    while (const auto event = bus_->take()) desk_.on_event(*event, now);
    desk_.on_time(now);
    while (auto scene = desk_.take_scene()) {
      const auto added = shelf_.add(scene->hash, scene->bytes);
      added ? desk_.on_scene_ready(scene->hash)
            : desk_.on_scene_unusable(scene->hash, added.error());
    }
    while (auto job = desk_.next_job(now)) {
      running_.push_back({std::move(*job), now + milliseconds(1 + random_.below(25))});
    }
    desk_.take_revoked();  // they end soon enough
    for (auto run = running_.begin(); run != running_.end();) {
      if (run->done_at > now) {
        ++run;
        continue;
      }
      ResultItem result = shelf_.solve(run->job, stop_);
      if (lie && !result.resolution.empty()) lie(run->job, result.resolution);
      desk_.on_ended(run->job, std::move(result));
      run = running_.erase(run);
    }
    while (const auto out = desk_.next_outgoing(now)) {
      desk_.on_published(bus_->publish(out->to, out->message), now);
    }
  }
  Time next() const {
    Time next = desk_.next_deadline().value_or(Time::max());
    for (const Run& run : running_) next = std::min(next, run.done_at);
    return next;
  }

 private:
  struct Run {
    TaskDesk::Job job;
    Time done_at;
  };

  static TaskDesk::Settings settings(std::uint32_t protocol) {
    TaskDesk::Settings settings = settings_of_a_worker();
    settings.info.protocol = protocol;
    return settings;
  }

  std::unique_ptr<Bus> bus_;
  TaskDesk desk_;
  SceneShelf shelf_;
  RandomStream random_;
  std::atomic<bool> stop_{false};
  std::list<Run> running_;
};

class Cluster {
 public:
  Cluster(std::uint64_t seed, bool suffers)
      : network_(seed), random_(seed), suffers_(suffers), bus_(network_.join(Role::kCoordinator)) {}

  SimulatedWorker& start_worker(std::uint32_t protocol = kProtocol) {
    workers_.push_back(
        std::make_unique<SimulatedWorker>(network_, random_.below(1 << 30), protocol));
    return *workers_.back();
  }

  // The bytes of the plan.
  std::string plan(const std::shared_ptr<const Scene>& scene) {
    const auto one_turn = [this](Bus&, std::optional<Time> deadline) { return turn(deadline); };
    return testing::planned_bytes(
        scene, [&](const CollisionWorld&, const CollisionWorld& detection) {
          auto port = std::make_unique<DirectPort>(*bus_, board_, 1, one_turn);
          return std::make_unique<RemoteCrew>(std::move(port), detection);
        });
  }

  const TaskBoard& board() const { return board_; }
  Time now() const { return network_.now(); }

 private:
  Time turn(std::optional<Time> deadline) {
    const Time now = network_.now();
    EXPECT_LT(now, std::chrono::minutes(5)) << "stuck";
    if (now >= std::chrono::minutes(5)) throw std::runtime_error("stuck");
    if (suffers_ && now >= strike_at_) {
      strike();
      strike_at_ = now + milliseconds(random_.below(60));
    }
    for (const auto& worker : workers_) {
      if (!worker->dead && !worker->frozen) worker->step(now);
    }
    Time next = now + milliseconds(20);
    if (deadline) next = std::min(next, *deadline);
    if (const auto due = network_.next()) next = std::min(next, *due);
    for (const auto& worker : workers_) {
      if (!worker->dead && !worker->frozen) next = std::min(next, worker->next());
    }
    network_.advance_to(std::max(next, now + std::chrono::microseconds(10)));
    return network_.now();
  }

  void strike() {
    if (++strikes_ > 40) {  // in the end it gets quiet
      network_.set_faults({});
      for (const auto& worker : workers_) {
        network_.heal(bus_->self(), worker->id());
        thaw(*worker);
      }
      if (strikes_ == 41) start_worker();
      return;
    }
    SimulatedWorker& victim = *workers_[random_.below(workers_.size())];
    switch (random_.below(12)) {
      case 0:
        if (!victim.dead) network_.kill(victim.id());
        victim.dead = true;
        start_worker();
        break;
      case 1:
        network_.cut(bus_->self(), victim.id());
        break;
      case 2:
        network_.heal(bus_->self(), victim.id());
        break;
      case 3:
        network_.set_faults({0.1 * static_cast<double>(random_.below(4)), 0.1, 0.3});
        break;
      case 4:
        network_.set_faults({});
        break;
      case 5:
        if (!victim.dead) network_.freeze(victim.id());
        victim.frozen = true;
        break;
      case 6:
        thaw(victim);
        break;
      case 7:
        start_worker(kProtocol + 1);
        break;
      case 8:
        start_worker().lie = [own = std::uint8_t(random_.below(256))](const auto&,
                                                                      Bytes& resolution) {
          resolution.resize(3);
          resolution.push_back(own);
        };
        break;
      default:
        break;
    }
  }
  void thaw(SimulatedWorker& worker) {
    if (!worker.frozen) return;
    worker.frozen = false;
    if (!worker.dead) network_.thaw(worker.id());
  }

  SimulatedNetwork network_;
  RandomStream random_;
  bool suffers_;
  std::unique_ptr<Bus> bus_;
  TaskBoard board_{TaskBoard::Settings{}};
  std::vector<std::unique_ptr<SimulatedWorker>> workers_;
  Time strike_at_{0};
  int strikes_ = 0;
};

class Clusters : public ::testing::TestWithParam<const char*> {};

TEST_P(Clusters, PlanAsOneProcessDoesWhateverTheNumberOfWorkers) {
  const auto scene = testing::example_scene(GetParam());
  ASSERT_NE(scene, nullptr);
  const auto expected = testing::bytes_planned_in_process(scene);
  for (const int workers : {1, 2, 3, 5, 9}) {
    Cluster cluster(1, false);
    for (int i = 0; i < workers; ++i) cluster.start_worker();
    EXPECT_EQ(cluster.plan(scene), expected) << workers << " workers";
    EXPECT_EQ(cluster.board().counters().reassigned, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Clusters,
                         ::testing::Values("peer-inlet", "low-mobile-16", "adaptive-mobile",
                                           "mixed-cell", "rack-drones", "high-manipulator-4"));

// A worker that returns what does not hold, once it can, in the scene that it is in.
class Liar {
 public:
  Liar(const std::shared_ptr<const Scene>& scene, testing::Lie lie)
      : world_(scene, kProofMargin), lie_(lie) {}

  void operator()(const TaskDesk::Job& job, Bytes& bytes) {
    const auto subproblem = decode_subproblem(job.subproblem, world_.scene());
    auto resolution = decode_resolution(bytes, world_.scene(), *subproblem);
    if (!resolution->solved || !lie_(world_, *subproblem, *resolution)) return;
    bytes = encode_resolution(*resolution);
    ++lies;
  }
  std::size_t lies = 0;

 private:
  CollisionWorld world_;
  testing::Lie lie_;
};

struct LyingCase {
  const char* name;
  testing::Lie lie;
  const char* scene;
  const char* found_out;  // part of what it is told
};

class ClustersWithALiar : public ::testing::TestWithParam<LyingCase> {};

TEST_P(ClustersWithALiar, FindItOutAndPlanAsOnAQuietDay) {
  const auto scene = testing::example_scene(GetParam().scene);
  const auto expected = testing::paths_planned_in_process(scene);
  Cluster cluster(1, false);
  cluster.start_worker();
  Liar liar(scene, GetParam().lie);
  SimulatedWorker& lying = cluster.start_worker();
  lying.lie = std::ref(liar);
  EXPECT_EQ(cluster.plan(scene), expected);
  EXPECT_GE(liar.lies, 1U) << "it never came to lie";
  const WorkerRecord& record = cluster.board().workers().at(lying.id());
  EXPECT_EQ(record.standing, WorkerRecord::Standing::kDistrusted);
  EXPECT_THAT(record.why, ::testing::HasSubstr(GetParam().found_out));
}

INSTANTIATE_TEST_SUITE_P(
    Lies, ClustersWithALiar,
    ::testing::Values(
        LyingCase{"EndsElsewhere", testing::ends_elsewhere, "peer-inlet", "end at its goal"},
        LyingCase{"IsTooFast", testing::is_too_fast, "peer-inlet", "faster than it can"},
        LyingCase{"CutsThroughAnObstacle", testing::cuts_through_an_obstacle, "depot-map",
                  "comes too close to \""},
        LyingCase{"TouchesItsTeam", testing::touches_its_team, "peer-parallel-008",
                  "come too close to each other"},
        LyingCase{"TouchesAnOutsider", testing::touches_an_outsider, "random-crossing-0032",
                  "come too close to each other"}),
    [](const auto& param_info) { return param_info.param.name; });

// Else they would be distrusted one after the other.
TEST(ClustersWithWrongSolvers, BlameTheTaskOnceTwoReturnTheSame) {
  const auto scene = testing::example_scene("peer-inlet");
  Cluster cluster(1, false);
  Liar same_solver(scene, testing::touches_its_team);
  for (int i = 0; i < 4; ++i) cluster.start_worker().lie = std::ref(same_solver);
  try {
    cluster.plan(scene);
    FAIL() << "planned";
  } catch (const TaskFailure& failure) {
    EXPECT_THAT(failure.what(), ::testing::HasSubstr("come too close to each other"));
    const auto task = decode_task_record(encode_task_record(failure.record()));
    ASSERT_TRUE(task) << task.error();
    EXPECT_THAT(default_solver_names(), ::testing::IsSupersetOf(task->solvers));
    EXPECT_EQ(task->why, failure.what());
    EXPECT_EQ(task->subproblem.tasks.size(), 2U);
  }
  EXPECT_EQ(same_solver.lies, 2U);
  const auto is_distrusted = [](const auto& entry) {
    return entry.second.standing == WorkerRecord::Standing::kDistrusted;
  };
  EXPECT_EQ(std::ranges::count_if(cluster.board().workers(), is_distrusted), 1);
}

TEST(SufferingClusters, PlanAsOnAQuietDay) {
  const char* told = std::getenv("ACCORD_CLUSTERS");
  const std::uint64_t clusters = told != nullptr ? std::strtoull(told, nullptr, 10) : 150;
  std::uint64_t lost = 0, reassigned = 0, failures = 0;
  for (const char* name : {"peer-parallel-008", "low-mobile-08", "adaptive-mobile", "mixed-cell"}) {
    const auto scene = testing::example_scene(name);
    const auto expected = testing::bytes_planned_in_process(scene);
    for (std::uint64_t seed = 1; seed <= clusters / 4; ++seed) {
      Cluster cluster(seed, true);
      for (int i = 0; i < 3; ++i) cluster.start_worker();
      try {
        ASSERT_EQ(cluster.plan(scene), expected) << name << ", seed " << seed;
      } catch (const TaskFailure&) {
        ++failures;  // three workers in a row fell silent over one task: it takes the blame
      }
      lost += cluster.board().counters().workers_lost;
      reassigned += cluster.board().counters().reassigned;
    }
  }
  EXPECT_GT(lost, clusters / 3) << "the clusters hardly suffered";
  EXPECT_GT(reassigned, clusters / 3);
  EXPECT_LE(failures, clusters / 20);
}

}  // namespace
}  // namespace accord
