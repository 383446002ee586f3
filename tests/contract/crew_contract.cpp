#include "tests/contract/crew_contract.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>

#include "common/geometry/tolerances.h"
#include "common/io/wire/resolution_codec.h"
#include "common/planning/method_names.h"
#include "tests/support/problems.h"
#include "worker/worker.h"

namespace accord::crew_contract {
namespace {

using namespace std::chrono_literals;
using testing::Problem;

constexpr auto kQuiet = 200ms;  // how long nothing is to happen

// Becomes true when a while has passed.
class Alarm {
 public:
  explicit Alarm(std::chrono::milliseconds after)
      : thread_([this, after](const std::stop_token& token) {
          const auto end = std::chrono::steady_clock::now() + after;
          while (!token.stop_requested() && std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(1ms);
          }
          rings_ = true;
        }) {}
  const std::atomic<bool>& rings() const { return rings_; }

 private:
  std::atomic<bool> rings_{false};
  std::jthread thread_;
};

// Complete, as what travels to workers has to be.
Problem complete(Problem problem) {
  for (Task& task : problem.subproblem.tasks) task.tail = testing::path({{task.to, task.goal}});
  return problem;
}

Problem crossing_discs() {
  return complete(testing::crossing_discs());
}

// Two discs that change places in a corridor without room to pass, for solvers that never give up.
Problem endless() {
  Problem problem = testing::whole_problem(testing::SceneBuilder(-6, -0.6, 6, 0.6)
                                               .disk(0.5, {-4, 0}, {4, 0})
                                               .disk(0.5, {4, 0}, {-4, 0})
                                               .build(),
                                           2);
  problem.subproblem.limits = SolverLimits::unlimited();
  return complete(std::move(problem));
}

// One of them on its own: quickly done.
Subproblem short_one(const Subproblem& from, std::size_t robot, std::uint64_t seed) {
  Subproblem out = from;
  out.seed = seed;
  out.limits = {};
  out.tasks = {from.tasks[robot]};
  out.outsiders.clear();
  return out;
}

// A crew with work in hand, and what it is told.
class Foremost {
 public:
  Foremost(const Candidate& candidate, const Problem& problem, unsigned hands)
      : problem_(problem),
        patience_(candidate.patience),
        crew_(candidate.make(problem.scene, hands)) {}

  Crew& crew() { return *crew_; }

  Ticket begin(Subproblem subproblem, bool is_ahead = false,
               std::vector<std::string> solvers = {"decoupled-prm"}, double seconds = 0.01) {
    const Ticket ticket = next_++;
    Attempt attempt{ticket, std::make_shared<const Subproblem>(std::move(subproblem)),
                    std::move(solvers), is_ahead, seconds};
    crew_->begin({std::move(attempt)});
    return ticket;
  }
  Ticket begin_endless(bool is_ahead) { return begin(problem_.subproblem, is_ahead); }
  Ticket begin_short(bool is_ahead) {
    return begin(short_one(problem_.subproblem, 0, next_), is_ahead);
  }

  // Whether all of these are back in time; whatever else comes is noted, too.
  bool are_back(const std::vector<Ticket>& tickets,
                std::optional<std::chrono::milliseconds> patience = {}) {
    const Alarm alarm(patience.value_or(patience_));
    const auto is_here = [this](Ticket ticket) { return back_.contains(ticket); };
    while (!std::ranges::all_of(tickets, is_here)) {
      const std::vector<Attempted> some = crew_->wait(alarm.rings());
      for (const Attempted& one : some) {
        if (one.failure) std::rethrow_exception(one.failure);
        ++times_[one.ticket];
        back_[one.ticket] = one;
      }
      if (some.empty() && alarm.rings()) return false;
    }
    return true;
  }

  const std::map<Ticket, Attempted>& back() const { return back_; }
  int times(Ticket ticket) const { return times_.contains(ticket) ? times_.at(ticket) : 0; }

 private:
  Problem problem_;
  std::chrono::milliseconds patience_;
  std::unique_ptr<Crew> crew_;
  Ticket next_ = 1;
  std::map<Ticket, Attempted> back_;
  std::map<Ticket, int> times_;
};

Breach gives_back_what_a_worker_makes_of_it(const Candidate& candidate) {
  const Problem problem = crossing_discs();
  const CollisionWorld world(problem.scene, kPlanningMargin);
  const Worker worker(world);
  const std::atomic<bool> stop{false};
  for (const unsigned hands : {1U, 2U, 3U}) {
    Foremost foremost(candidate, problem, hands);
    std::map<Ticket, Bytes> expected;
    std::vector<Ticket> tickets;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Subproblem subproblem = problem.subproblem;
      if (seed % 3 != 0) subproblem = short_one(subproblem, seed % 2, seed);
      subproblem.seed = seed;
      tickets.push_back(foremost.begin(subproblem, false, default_solver_names()));
      expected[tickets.back()] =
          encode_resolution(worker.solve(subproblem, default_solver_names(), stop));
    }
    if (!foremost.are_back(tickets)) return "not all came back";
    for (const Ticket ticket : tickets) {
      if (encode_resolution(foremost.back().at(ticket).resolution) != expected[ticket]) {
        return "something else came back than a worker makes of it";
      }
    }
    const Ticket last = foremost.begin_short(false);
    if (!foremost.are_back({last})) return "it works once only";
    for (const Ticket ticket : tickets) {
      if (foremost.times(ticket) != 1) return "an attempt came back twice";
    }
  }
  return {};
}

Breach tries_the_solvers_of_each_attempt(const Candidate& candidate) {
  const Problem problem = crossing_discs();
  Foremost foremost(candidate, problem, 2);
  std::vector<Ticket> tickets;
  for (const char* solver : {"decoupled-prm", "composite-prm"}) {
    tickets.push_back(foremost.begin(problem.subproblem, false, {solver}));
  }
  if (!foremost.are_back(tickets)) return "not all came back";
  const auto solver = [&](std::size_t i) {
    return foremost.back().at(tickets[i]).resolution.solver;
  };
  if (solver(0) != "decoupled-prm" || solver(1) != "composite-prm") return "others were tried";
  return {};
}

Breach says_how_many_hands_it_has(const Candidate& candidate) {
  for (const unsigned hands : {1U, 3U}) {
    if (Foremost(candidate, endless(), hands).crew().hands() != hands) return "it has miscounted";
  }
  return {};
}

Breach works_with_all_hands_at_once(const Candidate& candidate) {
  Foremost foremost(candidate, endless(), 3);
  foremost.begin_endless(false);
  foremost.begin_endless(false);
  if (!foremost.are_back({foremost.begin_short(false)})) return "a hand was idle";
  return {};
}

Breach lets_idle_hands_work_ahead(const Candidate& candidate) {
  Foremost foremost(candidate, endless(), 2);
  foremost.begin_endless(false);
  if (!foremost.are_back({foremost.begin_short(true)})) return "a hand was idle";
  return {};
}

Breach puts_off_what_is_ahead_of_need(const Candidate& candidate) {
  Foremost foremost(candidate, endless(), 2);
  foremost.begin_endless(true);
  foremost.begin_endless(true);
  const Ticket first = foremost.begin_short(false), second = foremost.begin_short(false);
  if (!foremost.are_back({first, second})) return "what is needed had to wait";
  return {};
}

Breach goes_on_with_what_was_put_off(const Candidate& candidate) {
  // Takes some milliseconds.
  const Problem problem = complete(testing::discs_in_a_corridor_with_a_pocket());
  Foremost foremost(candidate, problem, 2);
  std::vector<Ticket> ahead;
  for (int i = 0; i < 4; ++i) {
    ahead.push_back(foremost.begin(problem.subproblem, true, {"composite-prm"}));
  }
  // Each time, some of them are under way.
  for (int i = 0; i < 10; ++i) {
    std::this_thread::sleep_for(1ms);
    const Ticket first = foremost.begin_short(false), second = foremost.begin_short(false);
    if (!foremost.are_back({first, second})) return "what is needed did not come back";
  }
  foremost.crew().hurry(ahead);
  if (!foremost.are_back(ahead)) return "what was put off did not come back";
  for (const Ticket ticket : ahead) {
    if (!foremost.back().at(ticket).resolution.solved) return "it came back half done";
  }
  return {};
}

Breach works_ahead_in_the_order_it_was_told(const Candidate& candidate) {
  Foremost foremost(candidate, endless(), 2);
  foremost.begin_endless(false);
  const Ticket first = foremost.begin_short(true);
  foremost.begin_endless(true);
  const Ticket last = foremost.begin_short(true);
  if (!foremost.are_back({first})) return "a hand was idle";
  if (foremost.are_back({last}, kQuiet)) return "one that was told last came first";
  return {};
}

Breach takes_what_is_hurried_for_needed(const Candidate& candidate) {
  Foremost foremost(candidate, endless(), 2);
  foremost.begin_endless(false);
  foremost.begin_endless(true);
  const Ticket ticket = foremost.begin_short(true);
  if (foremost.are_back({ticket}, kQuiet)) return "nothing was under way";
  foremost.crew().hurry({ticket});
  if (!foremost.are_back({ticket})) return "it still waits for one that is ahead of need";
  return {};
}

Breach gives_back_nothing_that_was_dropped(const Candidate& candidate) {
  for (const unsigned hands : {1U, 2U}) {
    Foremost foremost(candidate, crossing_discs(), hands);
    std::vector<Ticket> kept, dropped;
    for (int i = 0; i < 60; ++i) {
      (i % 2 == 0 ? kept : dropped).push_back(foremost.begin_short(false));
    }
    foremost.crew().drop(dropped);
    if (!foremost.are_back(kept)) return "others were dropped with them";
    for (const Ticket ticket : dropped) {
      if (foremost.times(ticket) > 0) return "a dropped one came back";
    }
  }
  return {};
}

Breach has_hands_free_for_others_when_one_is_dropped(const Candidate& candidate) {
  Foremost foremost(candidate, endless(), 2);
  const Ticket first = foremost.begin_endless(false), second = foremost.begin_endless(false);
  const Ticket third = foremost.begin_short(false);
  if (foremost.are_back({third}, kQuiet)) return "there was a third hand";
  foremost.crew().drop({first, second});
  if (!foremost.are_back({third})) return "the hands went on with what was dropped";
  return {};
}

// A crew that did so waited for ever: what was left for the caller to do was left by the caller,
// too, which saw that something had ended.
Breach does_what_is_begun_when_others_have_ended(const Candidate& candidate) {
  const Problem problem = crossing_discs();
  Foremost foremost(candidate, problem, 2);
  const Ticket first = foremost.begin_short(false);
  std::this_thread::sleep_for(kQuiet);  // it has ended, and nobody has asked
  const Ticket second =
      foremost.begin(short_one(problem.subproblem, 1, 99), false, {"decoupled-prm"}, 0);
  if (!foremost.are_back({first, second})) return "an attempt was left undone";
  return {};
}

Breach ends_when_it_is_stopped(const Candidate& candidate) {
  for (const unsigned hands : {1U, 2U}) {
    Foremost foremost(candidate, endless(), hands);
    const Ticket ticket = foremost.begin_endless(false);
    const Alarm alarm(50ms);
    if (!foremost.crew().wait(alarm.rings()).empty()) return "something came back all the same";
    foremost.crew().drop({ticket});
  }
  return {};
}

}  // namespace

const std::vector<Check>& checks() {
  static const std::vector<Check> all{
      {"GivesBackWhatAWorkerMakesOfIt", gives_back_what_a_worker_makes_of_it},
      {"TriesTheSolversOfEachAttempt", tries_the_solvers_of_each_attempt},
      {"SaysHowManyHandsItHas", says_how_many_hands_it_has},
      {"WorksWithAllHandsAtOnce", works_with_all_hands_at_once},
      {"LetsIdleHandsWorkAhead", lets_idle_hands_work_ahead},
      {"PutsOffWhatIsAheadOfNeed", puts_off_what_is_ahead_of_need},
      {"GoesOnWithWhatWasPutOff", goes_on_with_what_was_put_off},
      {"WorksAheadInTheOrderItWasTold", works_ahead_in_the_order_it_was_told},
      {"TakesWhatIsHurriedForNeeded", takes_what_is_hurried_for_needed},
      {"GivesBackNothingThatWasDropped", gives_back_nothing_that_was_dropped},
      {"HasHandsFreeForOthersWhenOneIsDropped", has_hands_free_for_others_when_one_is_dropped},
      {"DoesWhatIsBegunWhenOthersHaveEnded", does_what_is_begun_when_others_have_ended},
      {"EndsWhenItIsStopped", ends_when_it_is_stopped},
  };
  return all;
}

const Check& check_named(const std::string& name) {
  const auto found = std::ranges::find(checks(), name, &Check::name);
  if (found == checks().end()) throw std::invalid_argument("no check " + name);
  return *found;
}

}  // namespace accord::crew_contract
