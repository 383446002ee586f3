// Threads of this process and worker processes keep the contract of Crew, and wrong crews do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "client/engine/local_crew.h"
#include "common/geometry/tolerances.h"
#include "common/planning/method_names.h"
#include "common/transport/simulated_network.h"
#include "coordinator/dispatch/direct_port.h"
#include "coordinator/dispatch/remote_crew.h"
#include "tests/contract/crew_contract.h"
#include "worker/service/job_threads.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using crew_contract::Check;
using Time = Bus::Duration;

// A crew with all that it stands on.
template <typename Ground>
class Standing final : public Crew {
 public:
  template <typename... Args>
  explicit Standing(Args&&... args) : ground_(std::forward<Args>(args)...) {}

  void begin(std::vector<Attempt> attempts) override { ground_.crew->begin(std::move(attempts)); }
  void hurry(const std::vector<Ticket>& tickets) override { ground_.crew->hurry(tickets); }
  void drop(const std::vector<Ticket>& tickets) override { ground_.crew->drop(tickets); }
  std::vector<Attempted> wait(const std::atomic<bool>& stop) override {
    return ground_.crew->wait(stop);
  }
  std::size_t hands() const override { return ground_.crew->hands(); }

 private:
  Ground ground_;
};

struct World {
  World(const std::shared_ptr<const Scene>& scene, unsigned hands)
      : world(scene, kPlanningMargin), crew(std::make_unique<LocalCrew>(world, hands)) {}

  CollisionWorld world;
  std::unique_ptr<Crew> crew;
};

std::unique_ptr<Crew> local_crew(const std::shared_ptr<const Scene>& scene, unsigned hands) {
  return std::make_unique<Standing<World>>(scene, hands);
}

// A worker process in all but the process: books, scenes and threads, on a network of this
// thread's.
class InProcessWorker {
 public:
  InProcessWorker(SimulatedNetwork& network, unsigned threads)
      : bus_(network.join(Role::kWorker)),
        desk_(settings(threads)),
        threads_(shelf_, to_string(bus_->self()), threads, [] {}) {}

  void turn(Time now) {
    while (const auto event = bus_->take()) desk_.on_event(*event, now);
    while (auto outcome = threads_.take()) {
      if (auto* ended = std::get_if<JobThreads::Ended>(&*outcome)) {
        desk_.on_ended(ended->job, std::move(ended->result));
      } else {
        desk_.on_scene_ready(std::get<JobThreads::SceneOutcome>(*outcome).scene);
      }
    }
    desk_.on_time(now);
    while (auto scene = desk_.take_scene()) threads_.make_ready(std::move(*scene));
    for (const TaskKey& key : desk_.take_revoked()) threads_.stop(key);
    while (auto job = desk_.next_job(now)) threads_.start(std::move(*job));
    while (const auto out = desk_.next_outgoing(now)) {
      desk_.on_published(bus_->publish(out->to, out->message), now);
    }
  }

 private:
  static TaskDesk::Settings settings(unsigned threads) {
    TaskDesk::Settings settings;
    settings.info.threads = threads;
    settings.info.task_bytes = 1 << 20;
    settings.info.scene_bytes = 1 << 24;
    return settings;
  }

  std::unique_ptr<Bus> bus_;
  TaskDesk desk_;
  SceneShelf shelf_;
  JobThreads threads_;
};

// A worker of two threads where there are as many, and workers of one.
struct Cluster {
  Cluster(const std::shared_ptr<const Scene>& scene, unsigned hands)
      : network(1), bus(network.join(Role::kCoordinator)), detection(scene, kDetectionMargin) {
    for (unsigned left = hands; left > 0;) {
      const unsigned threads = left > 2 ? 2 : 1;
      workers.push_back(std::make_unique<InProcessWorker>(network, threads));
      left -= threads;
    }
    const auto turn = [this](Bus&, std::optional<Time>) { return advance(); };
    auto port = std::make_unique<DirectPort>(*bus, board, 1, turn);
    DirectPort* const pumped = port.get();
    crew = std::make_unique<RemoteCrew>(std::move(port), detection);
    while (board.threads() < hands) pumped->turn();
  }

  Time advance() {
    for (const auto& worker : workers) worker->turn(network.now());
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    network.advance_to(std::chrono::steady_clock::now() - began);
    return network.now();
  }

  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  SimulatedNetwork network;
  std::unique_ptr<Bus> bus;
  CollisionWorld detection;
  TaskBoard board{TaskBoard::Settings{}};
  std::vector<std::unique_ptr<InProcessWorker>> workers;
  std::unique_ptr<Crew> crew;
};

std::unique_ptr<Crew> remote_crew(const std::shared_ptr<const Scene>& scene, unsigned hands) {
  return std::make_unique<Standing<Cluster>>(scene, hands);
}

class Crews : public ::testing::TestWithParam<Check> {};

TEST_P(Crews, OfThreadsKeepTheContract) {
  EXPECT_EQ(GetParam().run({local_crew, 20s}), "");
}

TEST_P(Crews, OfWorkerProcessesKeepTheContract) {
  EXPECT_EQ(GetParam().run({remote_crew, 20s}), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, Crews, ::testing::ValuesIn(crew_contract::checks()),
                         [](const auto& param_info) { return param_info.param.name; });

// ---- Wrong ones ----

// Passes everything on, but for what a wrong one does otherwise.
class WrongCrew : public Crew {
 public:
  explicit WrongCrew(std::unique_ptr<Crew> right) : right_(std::move(right)) {}

  void begin(std::vector<Attempt> attempts) override { right_->begin(std::move(attempts)); }
  void hurry(const std::vector<Ticket>& tickets) override { right_->hurry(tickets); }
  void drop(const std::vector<Ticket>& tickets) override { right_->drop(tickets); }
  std::vector<Attempted> wait(const std::atomic<bool>& stop) override { return right_->wait(stop); }
  std::size_t hands() const override { return right_->hands(); }

 protected:
  std::unique_ptr<Crew> right_;
};

struct Repeating : WrongCrew {
  using WrongCrew::WrongCrew;
  std::vector<Attempted> wait(const std::atomic<bool>& stop) override {
    std::vector<Attempted> out = right_->wait(stop);
    if (!out.empty()) out.push_back(out.front());
    return out;
  }
};

struct Wilful : WrongCrew {
  using WrongCrew::WrongCrew;
  void begin(std::vector<Attempt> attempts) override {
    for (Attempt& attempt : attempts) attempt.solvers = default_solver_names();
    right_->begin(std::move(attempts));
  }
};

struct Deaf : WrongCrew {
  using WrongCrew::WrongCrew;
  void drop(const std::vector<Ticket>&) override {}
};

struct Unhurried : WrongCrew {
  using WrongCrew::WrongCrew;
  void hurry(const std::vector<Ticket>&) override {}
};

struct Eager : WrongCrew {
  using WrongCrew::WrongCrew;
  void begin(std::vector<Attempt> attempts) override {
    for (Attempt& attempt : attempts) attempt.is_ahead = false;
    right_->begin(std::move(attempts));
  }
};

struct Lazy : WrongCrew {
  using WrongCrew::WrongCrew;
  void begin(std::vector<Attempt> attempts) override {
    std::erase_if(attempts, [](const Attempt& attempt) { return attempt.is_ahead; });
    right_->begin(std::move(attempts));
  }
};

struct Boastful : WrongCrew {
  using WrongCrew::WrongCrew;
  std::size_t hands() const override { return right_->hands() + 1; }
};

constexpr auto kShortPatience = 300ms;

template <typename Wrong>
std::string breach(const std::string& check) {
  const auto make = [](const auto& scene, unsigned hands) {
    return std::make_unique<Wrong>(local_crew(scene, hands));
  };
  return crew_contract::check_named(check).run({make, kShortPatience});
}

TEST(WrongCrew, IsFoundOut) {
  EXPECT_NE(breach<Repeating>("GivesBackWhatAWorkerMakesOfIt"), "");
  EXPECT_NE(breach<Wilful>("TriesTheSolversOfEachAttempt"), "");
  EXPECT_NE(breach<Deaf>("GivesBackNothingThatWasDropped"), "");
  EXPECT_NE(breach<Boastful>("SaysHowManyHandsItHas"), "");
}

// These wait for what does not come; a thread left idle is a hand too few.
TEST(WrongCrew, IsFoundOutByWhatDoesNotCome) {
  const auto one_hand_less = [](const auto& scene, unsigned hands) {
    return local_crew(scene, std::max(1U, hands - 1));
  };
  EXPECT_NE(
      crew_contract::check_named("WorksWithAllHandsAtOnce").run({one_hand_less, kShortPatience}),
      "");
  EXPECT_NE(breach<Eager>("PutsOffWhatIsAheadOfNeed"), "");
  EXPECT_NE(breach<Lazy>("LetsIdleHandsWorkAhead"), "");
  EXPECT_NE(breach<Unhurried>("TakesWhatIsHurriedForNeeded"), "");
  EXPECT_NE(breach<Deaf>("HasHandsFreeForOthersWhenOneIsDropped"), "");
}

}  // namespace
}  // namespace accord
