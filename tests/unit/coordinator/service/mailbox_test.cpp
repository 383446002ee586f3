#include "coordinator/service/mailbox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace accord {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr EndpointId kWorker{7};

NewTask task_of(TaskId id, bool is_ahead = false) {
  return {id, {1}, {2}, 1, is_ahead};
}

// A mailbox before a real board with one worker of one thread, played by the test.
class MailboxTest : public ::testing::Test {
 protected:
  MailboxTest() {
    Announcement announcement;
    announcement.threads = 1;
    announcement.task_bytes = 1 << 20;
    board_.on_event({kWorker, PeerAppeared{}}, now_);
    board_.on_event({kWorker, announcement}, now_);
    mailbox_.serve(board_);
    turn();
  }

  std::unique_ptr<TaskPort> open_port(RequestId request) {
    auto port = mailbox_.open_port(request);
    port->open({});
    return port;
  }
  // As the coordinator's loop; notes what the worker is given.
  void turn() {
    mailbox_.serve(board_);
    while (auto finished = board_.take_finished()) mailbox_.deliver(std::move(*finished));
    while (const auto out = board_.next_outgoing(now_)) {
      if (const auto* batch = std::get_if<TaskBatch>(&out->message)) {
        for (const TaskItem& item : batch->tasks) given_.push_back(item.key);
      } else if (const auto* command = std::get_if<Command>(&out->message)) {
        if (command->kind == Command::Kind::kRevoke) revoked_ = command->tasks;
      }
      board_.on_published(out->to, Published::kSent, now_);
    }
  }
  void finish(const TaskKey& task) {
    ResultItem result;
    result.key = task;
    result.resolution = {3};
    board_.on_event({kWorker, ResultBatch{{result}}}, now_);
  }

  std::atomic<int> wakes_ = 0;
  Mailbox mailbox_{[this] { ++wakes_; }};
  TaskBoard board_{TaskBoard::Settings{}};
  TaskBoard::Time now_{1s};
  std::vector<TaskKey> given_, revoked_;
  const std::atomic<bool> never_{false};
};

TEST_F(MailboxTest, CarriesTasksToTheBoardAndTheirResultsBack) {
  const auto port = open_port(1);
  const TaskId id = port->next_id();
  port->add({task_of(id)});
  EXPECT_EQ(board_.unfinished(), 0U) << "the board is the loop's";
  turn();
  ASSERT_THAT(given_, SizeIs(1));
  finish(given_[0]);
  turn();
  const auto finished = port->wait(never_);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->task, id);
  EXPECT_EQ(finished->resolution, Bytes{3});
}

TEST_F(MailboxTest, RousesTheLoopForAllThatItIsToDo) {
  const auto port = open_port(1);
  int before = wakes_;
  port->add({task_of(port->next_id())});
  EXPECT_GT(wakes_, before);
  before = wakes_;
  port->cancel({1});
  EXPECT_GT(wakes_, before);
}

TEST_F(MailboxTest, GivesPortsNamesOfTasksThatNoOtherHas) {
  const auto one = open_port(1), other = open_port(2);
  EXPECT_NE(one->next_id(), one->next_id());
  EXPECT_NE(one->next_id(), other->next_id());
}

TEST_F(MailboxTest, DeliversToThePortWhoseTaskItIs) {
  const auto one = open_port(1), other = open_port(2);
  const TaskId ones = one->next_id(), others = other->next_id();
  other->add({task_of(others)});
  one->add({task_of(ones)});
  turn();
  for (const TaskKey& task : std::vector(given_)) finish(task);
  turn();
  for (const TaskKey& task : std::vector(given_)) finish(task);
  turn();
  EXPECT_EQ(one->wait(never_)->task, ones);
  EXPECT_EQ(other->wait(never_)->task, others);
}

TEST_F(MailboxTest, DropsATaskThatFinishesWhenItsPortIsGone) {
  auto port = open_port(1);
  port->add({task_of(port->next_id())});
  turn();
  finish(given_.at(0));
  port.reset();  // the board has not heard of it yet
  while (auto finished = board_.take_finished()) mailbox_.deliver(std::move(*finished));
  turn();
  EXPECT_EQ(board_.unfinished(), 0U);

  const auto next = open_port(2);
  next->add({task_of(next->next_id())});
  given_.clear();
  turn();
  EXPECT_THAT(given_, SizeIs(1)) << "the worker is free for others";
}

TEST_F(MailboxTest, TakesBackWhatAPortThatIsGoneHadGivenOut) {
  auto port = open_port(1);
  port->add({task_of(port->next_id())});
  turn();
  port.reset();
  turn();
  EXPECT_EQ(revoked_, given_);
}

TEST_F(MailboxTest, EndsAWaitWhenItIsToStop) {
  const auto port = open_port(1);
  std::atomic<bool> stop{false};
  std::thread stopper([&] {
    std::this_thread::sleep_for(20ms);
    stop = true;
  });
  EXPECT_FALSE(port->wait(stop));
  stopper.join();
}

TEST_F(MailboxTest, EndsAWaitWhenATaskComes) {
  const auto port = open_port(1);
  port->add({task_of(port->next_id())});
  turn();
  std::thread loop([&] {
    std::this_thread::sleep_for(20ms);
    finish(given_.at(0));
    turn();
  });
  EXPECT_TRUE(port->wait(never_));
  loop.join();
}

TEST_F(MailboxTest, PassesOnWhatIsCancelled) {
  const auto port = open_port(1);
  const TaskId id = port->next_id();
  port->add({task_of(id)});
  turn();
  port->cancel({id});
  turn();
  EXPECT_EQ(board_.unfinished(), 0U);
  EXPECT_EQ(revoked_, given_);
}

TEST_F(MailboxTest, PassesOnWhatIsInAHurry) {
  const auto port = open_port(1);
  const TaskId needed = port->next_id(), ahead = port->next_id();
  port->add({task_of(needed), task_of(ahead, true)});
  turn();
  ASSERT_THAT(given_, ElementsAre(TaskKey{needed, 0})) << "there is one thread only";
  port->hurry({ahead});
  turn();
  EXPECT_THAT(given_, ElementsAre(TaskKey{needed, 0}, TaskKey{ahead, 0}));
}

TEST_F(MailboxTest, PassesOnWhetherAResultHolds) {
  const auto port = open_port(1);
  port->add({task_of(port->next_id())});
  turn();
  finish(given_.at(0));
  turn();
  port->reject(*port->wait(never_), "it does not hold");
  turn();
  EXPECT_EQ(board_.workers().at(kWorker).standing, WorkerRecord::Standing::kDistrusted);
  EXPECT_EQ(board_.unfinished(), 1U) << "it is to be done again";
}

TEST_F(MailboxTest, TellsPortsHowManyThreadsThereAre) {
  const auto port = open_port(1);
  EXPECT_EQ(port->threads(), 1U);
  board_.on_event({kWorker, PeerLost{}}, now_);
  turn();
  EXPECT_EQ(port->threads(), 0U);
}

}  // namespace
}  // namespace accord
