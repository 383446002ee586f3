#include "coordinator/forerunner.h"

#include <functional>
#include <utility>

#include "common/geometry/query_counter.h"

namespace accord {
namespace {

// What is guessed on top of guesses is hardly ever right for longer.
constexpr int kRoundsAhead = 8;

// One look ahead.
class Run {
 public:
  Run(const CollisionWorld& planning, const SubproblemFactory& factory, const Schedule& schedule,
      const ConflictBoard& board, const Adaptation& adaptation, const Likely& likely)
      : planning_(planning),
        likely_(likely),
        schedule_(schedule),
        board_(board, schedule_),
        adaptation_(adaptation, schedule_),
        round_(factory, schedule_, board_, adaptation_) {}

  std::vector<Subproblem> go(std::vector<Job> jobs, bool are_known, std::size_t most) {
    for (Job& job : jobs) take_up(job, are_known || look_up(job));
    for (int rounds = 0; rounds < kRoundsAhead && settled_ > 0 && unknown_ < most; ++rounds) {
      if (!round_.look_ahead()) break;
      settled_ = 0;
      std::vector<const Subproblem*> pending;
      for (const std::vector<Subproblem>& some : {std::cref(open_), std::cref(in_question_)}) {
        for (const Subproblem& subproblem : some) pending.push_back(&subproblem);
      }
      for (Job& job : round_.choose(pending)) {
        if (unknown_ >= most) break;
        foreseen_.push_back(job.subproblem);
        take_up(job, look_up(job));
      }
    }
    // Where all else is on its way: what would be asked if those that are left were exhausted.
    for (const Subproblem& subproblem : open_) {
      if (unknown_ >= most) break;
      if (subproblem.outsiders.empty()) continue;
      foreseen_.push_back(without_outsiders(subproblem));
      ++unknown_;
    }
    return std::move(foreseen_);
  }

 private:
  bool look_up(Job& job) {
    auto resolution = likely_(job.subproblem);
    if (resolution) job.resolution = std::move(*resolution);
    return resolution.has_value();
  }

  // Settles a job, if it can be told what becomes of it.
  void take_up(Job& job, bool is_known) {
    if (is_known && (!job.is_in_question() || find_robots_in_the_way(job))) {
      ++settled_;
      round_.settle(job);
      return;
    }
    ++unknown_;
    (is_known ? in_question_ : open_).push_back(std::move(job.subproblem));
  }

  bool find_robots_in_the_way(Job& job) {
    Subproblem without = without_outsiders(job.subproblem);
    const auto resolution = likely_(without);
    foreseen_.push_back(std::move(without));
    if (!resolution) return false;
    if (resolution->solved) job.in_the_way = hit_by(planning_, job.subproblem, *resolution);
    return true;
  }

  const CollisionWorld& planning_;
  const Likely& likely_;
  Schedule schedule_;
  ConflictBoard board_;
  Adaptation adaptation_;
  Round round_;
  std::vector<Subproblem> open_;         // nothing is known of them
  std::vector<Subproblem> in_question_;  // exhausted; who is in the way is not known
  std::vector<Subproblem> foreseen_;
  std::size_t settled_ = 0;  // in this round
  std::size_t unknown_ = 0;
};

}  // namespace

std::vector<Subproblem> Forerunner::look_ahead(const std::vector<Job>& jobs, bool are_known,
                                               const Likely& likely, std::size_t most) const {
  const SeparateCost cost;  // of guesses: not of the plan
  Run run(planning_, factory_, schedule_, board_, adaptation_, likely);
  return run.go(jobs, are_known, most);
}

}  // namespace accord
