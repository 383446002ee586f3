#include "coordinator/service/journal_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

#include "common/io/plan_file.h"
#include "coordinator/journal/memory_journal.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A journal on a disk that waits for the test.
class SlowJournal final : public MemoryJournal {
 public:
  // Every write waits from now on.
  void hold() {
    const std::lock_guard lock(mutex_);
    is_held_ = true;
  }
  void release() {
    {
      const std::lock_guard lock(mutex_);
      is_held_ = false;
    }
    changed_.notify_all();
  }
  void wait_until_it_writes() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !commits_.empty(); });
  }
  // How many requests each write had.
  std::vector<std::size_t> commits() const {
    const std::lock_guard lock(mutex_);
    return commits_;
  }

 private:
  Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) override {
    wait_for_the_disk(requests.size());
    return MemoryJournal::do_accept(requests);
  }
  Result<void> do_finish(const std::vector<FinishedRequest>& requests) override {
    wait_for_the_disk(requests.size());
    return MemoryJournal::do_finish(requests);
  }
  void wait_for_the_disk(std::size_t requests) {
    std::unique_lock lock(mutex_);
    commits_.push_back(requests);
    changed_.notify_all();
    changed_.wait(lock, [this] { return !is_held_; });
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool is_held_ = false;
  std::vector<std::size_t> commits_;
};

RequestDesk::Accept accept(const std::string& id) {
  return {{{id, {}, {1}, 5}}};
}

RequestDesk::Finish finish(const std::string& id, double when = 9) {
  Plan plan;
  plan.status = PlanStatus::kInfeasible;
  plan.message = "of " + id;
  return {{{id, plan.status, to_json(plan), when}}};
}

// An outcome in a word or two.
std::string in_words(const JournalThread::Outcome& outcome) {
  const auto all = [](const std::vector<std::string>& ids, const std::string& fault) {
    std::string out;
    for (const std::string& id : ids) out += " " + id;
    return out + (fault.empty() ? "" : ": " + fault);
  };
  if (const auto* accepted = std::get_if<JournalThread::Accepted>(&outcome)) {
    return "accepted" + all(accepted->ids, accepted->fault);
  }
  if (const auto* stored = std::get_if<JournalThread::Stored>(&outcome)) {
    return "stored" + all(stored->ids, stored->fault);
  }
  if (std::holds_alternative<JournalThread::NotForgotten>(outcome)) return "not forgotten";
  const auto& recalled = std::get<JournalThread::Recalled>(outcome);
  return "recalled " + recalled.id + ": " +
         (recalled.plan ? recalled.plan->message : recalled.plan.error());
}

class JournalThreadTest : public ::testing::Test {
 protected:
  // All that has become of what was started, once the thread has ended.
  std::vector<std::string> outcomes() {
    std::vector<std::string> out;
    // The last thing it does is told of as well.
    thread_->start(RequestDesk::Recall{"the last"});
    while (out.empty() || !out.back().starts_with("recalled the last")) {
      if (const auto outcome = thread_->take()) {
        out.push_back(in_words(*outcome));
      } else {
        std::this_thread::sleep_for(1ms);
      }
    }
    out.pop_back();
    return out;
  }

  SlowJournal journal_;
  std::atomic<int> wakes_ = 0;
  std::optional<JournalThread> thread_{std::in_place, journal_, [this] { ++wakes_; }};
};

TEST_F(JournalThreadTest, WritesTogetherWhatComesWhileItWaitsForTheDisk) {
  journal_.hold();
  thread_->start(accept("a"));
  journal_.wait_until_it_writes();
  for (const char* id : {"b", "c", "d"}) thread_->start(accept(id));
  journal_.release();
  EXPECT_THAT(outcomes(), ElementsAre("accepted a", "accepted b c d"));
  EXPECT_THAT(journal_.commits(), ElementsAre(1, 3));
}

TEST_F(JournalThreadTest, KeepsTheOrderOfWhatItWasAskedFor) {
  journal_.hold();
  thread_->start(accept("a"));
  journal_.wait_until_it_writes();
  thread_->start(accept("b"));
  thread_->start(finish("a"));
  thread_->start(finish("b"));
  thread_->start(accept("c"));
  thread_->start(RequestDesk::Recall{"b"});
  thread_->start(finish("c"));
  journal_.release();
  EXPECT_THAT(outcomes(), ElementsAre("accepted a", "accepted b", "stored a b", "accepted c",
                                      "recalled b: of b", "stored c"));
}

TEST_F(JournalThreadTest, SaysWhyAWriteHasFailedAndGoesOn) {
  journal_.fail_next_writes(1);
  thread_->start(accept("a"));
  const auto first = outcomes();
  thread_->start(accept("b"));
  EXPECT_THAT(first, ElementsAre(HasSubstr("accepted a: the journal cannot be written")));
  EXPECT_THAT(outcomes(), ElementsAre("accepted b"));
}

TEST_F(JournalThreadTest, SaysWhyAPlanCannotBeHad) {
  thread_->start(accept("a"));
  thread_->start(RequestDesk::Recall{"a"});
  thread_->start(RequestDesk::Recall{"b"});
  thread_->start(RequestDesk::Finish{{{"a", PlanStatus::kSolved, "no plan file", 9}}});
  thread_->start(RequestDesk::Recall{"a"});
  EXPECT_THAT(outcomes(), ElementsAre("accepted a", HasSubstr("\"a\" is not finished"),
                                      HasSubstr("\"b\" is not in the journal"), "stored a",
                                      HasSubstr("the plan that was kept cannot be read")));
}

TEST_F(JournalThreadTest, ForgetsHoweverManyThereAre) {
  for (int i = 0; i < 200; ++i) {
    const std::string id = std::to_string(i);
    thread_->start(accept(id));
    thread_->start(finish(id, i < 150 ? 9 : 20));
  }
  thread_->start(RequestDesk::Forget{10});
  outcomes();
  thread_.reset();
  EXPECT_EQ(journal_.counts()->finished, 50U);
}

TEST_F(JournalThreadTest, SaysThatItCouldNotForget) {
  thread_->start(accept("a"));
  thread_->start(finish("a"));
  EXPECT_THAT(outcomes(), ElementsAre("accepted a", "stored a"));
  journal_.fail_next_writes(1);
  thread_->start(RequestDesk::Forget{10});
  EXPECT_THAT(outcomes(), ElementsAre("not forgotten"));
  thread_->start(RequestDesk::Forget{10});
  EXPECT_THAT(outcomes(), ElementsAre());
  EXPECT_FALSE(*journal_.find("a"));
}

TEST_F(JournalThreadTest, CarriesOutAllThatWasAskedForBeforeItEnds) {
  journal_.hold();
  thread_->start(accept("a"));
  thread_->start(finish("a"));
  thread_->start(accept("b"));
  auto ended = std::async(std::launch::async, [this] { thread_.reset(); });
  EXPECT_EQ(ended.wait_for(10ms), std::future_status::timeout);
  journal_.release();
  ended.get();
  EXPECT_TRUE((*journal_.find("a"))->outcome);
  EXPECT_TRUE(*journal_.find("b"));
}

TEST_F(JournalThreadTest, RousesTheLoopForEveryOutcome) {
  thread_->start(accept("a"));
  thread_->start(RequestDesk::Recall{"a"});
  outcomes();
  thread_.reset();
  EXPECT_EQ(wakes_, 3);
}

}  // namespace
}  // namespace accord
