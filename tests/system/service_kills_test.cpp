// Processes of the service are killed, stopped and started anew at random moments, while requests
// are on their way: each of them ends with the plan that one process makes, to the byte.
//
// ACCORD_KILL_ROUNDS: how many rounds; 3 unless told (the campaign: 100, some six minutes).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "common/planning/random.h"
#include "tests/support/service_processes.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using testing::planned_here;
using testing::request_for;

constexpr int kStrikes = 5;  // of a round
// More workers die than strikes fall: no task is to take the blame for it.
const std::vector<std::string> kForgiving{"--deaths", "20"};

class Round {
 public:
  explicit Round(std::uint64_t seed) : random_(seed), manager_(service_.port(), patient()) {
    service_.start_coordinator(kForgiving);
    service_.start_worker();
    service_.start_worker();
  }

  void submit(const std::string& scene, std::uint64_t seed) {
    manager_.submit(request_for(scene, seed));
  }

  // What becomes of all that was submitted, by id.
  std::map<std::string, std::variant<RequestState, Plan, NoAnswer>> run() {
    std::map<std::string, std::variant<RequestState, Plan, NoAnswer>> ends;
    const auto give_up = Clock::now() + 90s;
    while (manager_.is_waiting() && Clock::now() < give_up) {
      auto event = manager_.next(10ms);
      if (event && !std::holds_alternative<RequestState>(event->what)) {
        ends.insert_or_assign(event->id, std::move(event->what));
      }
      if (Clock::now() >= strike_at_ && strikes_ < kStrikes) strike();
      if (stopped_ != nullptr && Clock::now() >= go_on_at_) go_on();
    }
    return ends;
  }
  const std::vector<std::string>& story() const { return story_; }

 private:
  static FleetManager::Settings patient() {
    FleetManager::Settings settings;
    settings.patience = 30s;
    return settings;
  }

  void strike() {
    ++strikes_;
    strike_at_ = Clock::now() + std::chrono::milliseconds(random_.below(700));
    auto& workers = service_.workers();
    const auto victim =
        std::next(workers.begin(), static_cast<std::ptrdiff_t>(random_.below(workers.size())));
    switch (random_.below(6)) {
      case 0:
        story_.emplace_back("kill -9 of a worker");
        replace(victim);
        break;
      case 1:
        story_.emplace_back("kill -9 of all workers");
        stopped_ = nullptr;
        workers.clear();
        service_.start_worker();
        service_.start_worker();
        break;
      case 2:
        story_.emplace_back("kill -9 of the coordinator");
        service_.kill_coordinator();
        service_.start_coordinator(kForgiving);
        break;
      case 3:
        story_.emplace_back("SIGSTOP of a worker");
        go_on();
        victim->signal(SIGSTOP);
        stopped_ = &*victim;
        go_on_at_ = Clock::now() + std::chrono::milliseconds(900 + random_.below(800));
        break;
      case 4:
        story_.emplace_back("SIGTERM to a worker");
        go_on();
        victim->signal(SIGTERM);
        service_.start_worker();
        break;
      default:
        story_.emplace_back("SIGTERM to the coordinator");
        end_coordinator();
        service_.start_coordinator(kForgiving);
        break;
    }
  }
  void end_coordinator() {
    service_.coordinator().signal(SIGTERM);
    const int status = service_.coordinator().wait();
    // One that has only just begun is not there yet to be asked.
    const bool is_too_early = WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM;
    EXPECT_TRUE(status == 0 || is_too_early) << status;
  }
  void replace(std::list<testing::ChildProcess>::iterator victim) {
    if (stopped_ == &*victim) stopped_ = nullptr;
    service_.workers().erase(victim);
    service_.start_worker();
  }
  void go_on() {
    if (stopped_ != nullptr) stopped_->signal(SIGCONT);
    stopped_ = nullptr;
  }

  RandomStream random_;
  testing::ServiceProcesses service_;
  FleetManager manager_;
  int strikes_ = 0;
  Clock::time_point strike_at_ = Clock::now() + 300ms;
  Clock::time_point go_on_at_;
  testing::ChildProcess* stopped_ = nullptr;
  std::vector<std::string> story_;
};

TEST(ServiceThatIsKilled, LosesNothingAndChangesNothing) {
  const char* told = std::getenv("ACCORD_KILL_ROUNDS");
  const std::uint64_t rounds = told != nullptr ? std::strtoull(told, nullptr, 10) : 3;
  const std::vector<std::string> scenes{"mixed-floor", "high-manipulator-4", "adaptive-mobile",
                                        "low-mobile-32"};
  std::map<std::string, std::string> expected;  // by id
  for (const std::string& scene : scenes) expected[scene + "-1"] = planned_here(scene);
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    Round round(seed);
    for (const std::string& scene : scenes) round.submit(scene, 1);
    const auto ends = round.run();
    std::string story = "round " + std::to_string(seed) + ":";
    for (const std::string& strike : round.story()) story += " " + strike + ";";
    for (const auto& [id, bytes] : expected) {
      const auto end = ends.find(id);
      ASSERT_NE(end, ends.end()) << story << " " << id << " has not ended";
      const auto* plan = std::get_if<Plan>(&end->second);
      ASSERT_NE(plan, nullptr) << story << " " << id << ": "
                               << std::get<NoAnswer>(end->second).reply.text;
      EXPECT_EQ(canonical_bytes(*plan), bytes) << story << " " << id << ": " << plan->message;
    }
  }
}

}  // namespace
}  // namespace accord
