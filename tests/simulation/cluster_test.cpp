// Planning by clusters that suffer: workers die, hang, come back, lie, are of another protocol;
// links are cut; messages get lost, come twice or out of order. The plan is the one of a quiet day.
//
// ACCORD_CLUSTERS: how many seeded clusters to run; 150 unless told (the campaign: 1000).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "common/geometry/query_counter.h"
#include "common/geometry/tolerances.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "coordinator/dispatch/direct_port.h"
#include "coordinator/dispatch/remote_crew.h"
#include "tests/simulation/lies.h"
#include "tests/support/planned_paths.h"
#include "tests/support/simulated_cluster.h"

namespace accord {
namespace {

using std::chrono::milliseconds;
using testing::SimulatedWorker;
using Time = Bus::Duration;

// A coordinator, without requests or a journal, and its workers.
class Cluster {
 public:
  Cluster(std::uint64_t seed, bool suffers)
      : cluster_(seed),
        random_(seed),
        suffers_(suffers),
        bus_(cluster_.network().join(Role::kCoordinator)) {}

  SimulatedWorker& start_worker() { return cluster_.start_worker(); }

  // The bytes of the plan.
  std::string plan(const std::shared_ptr<const Scene>& scene) {
    const auto one_turn = [this](Bus&, std::optional<Time> deadline) { return turn(deadline); };
    return testing::planned_bytes(
        scene, [&](const CollisionWorld&, const CollisionWorld& detection) {
          auto port = std::make_unique<DirectPort>(*bus_, board_, ++request_, one_turn);
          return std::make_unique<RemoteCrew>(std::move(port), detection);
        });
  }

  const TaskBoard& board() const { return board_; }

 private:
  Time turn(std::optional<Time> deadline) {
    const Time now = cluster_.now();
    EXPECT_LT(now, std::chrono::minutes(5)) << "stuck";
    if (now >= std::chrono::minutes(5)) throw std::runtime_error("stuck");
    if (suffers_ && now >= strike_at_) {
      strike();
      strike_at_ = now + milliseconds(random_.below(60));
    }
    cluster_.pass(deadline);
    return cluster_.now();
  }

  void strike() {
    if (++strikes_ <= 40) {
      cluster_.strike(bus_->self());
      return;
    }
    cluster_.calm(bus_->self());  // in the end it gets quiet
    if (strikes_ == 41) start_worker();
  }

  testing::SimulatedCluster cluster_;
  RandomStream random_;
  bool suffers_;
  std::unique_ptr<Bus> bus_;
  TaskBoard board_{TaskBoard::Settings{}};
  RequestId request_ = 0;
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
    EXPECT_EQ(cluster.board().counters().reassigned(), 0U);
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
    const SeparateCost not_of_planning;  // it is on the same thread
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
  const auto expected = testing::bytes_planned_in_process(scene);
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
      lost += cluster.board().counters().workers_lost();
      reassigned += cluster.board().counters().reassigned();
    }
  }
  EXPECT_GT(lost, clusters / 3) << "the clusters hardly suffered";
  EXPECT_GT(reassigned, clusters / 3);
  EXPECT_LE(failures, clusters / 20);
}

}  // namespace
}  // namespace accord
