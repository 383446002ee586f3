#include "coordinator/service/status_board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

namespace accord {
namespace {

using namespace std::chrono_literals;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr EndpointId kWorker{7};

class StatusBoardTest : public ::testing::Test {
 protected:
  void announce(EndpointId worker, std::uint32_t threads, std::uint32_t protocol = kProtocol) {
    Announcement announcement;
    announcement.protocol = protocol;
    announcement.threads = threads;
    announcement.task_bytes = 1 << 20;
    announcement.host = "hall 3";
    announcement.version = "1.2";
    board_.on_event({worker, PeerAppeared{}}, now_);
    board_.on_event({worker, announcement}, now_);
  }
  // What is told of workers and of the service after a while.
  void look(std::chrono::milliseconds later = 100ms) {
    now_ += later;
    workers_.clear();
    services_.clear();
    status_.update(board_, desk_, now_);
    while (auto news = status_.next()) {
      if (const auto* worker = std::get_if<WorkerStatus>(&*news)) workers_.push_back(*worker);
      if (const auto* service = std::get_if<ServiceStatus>(&*news)) services_.push_back(*service);
    }
  }

  TaskBoard board_{TaskBoard::Settings{}};
  RequestDesk desk_{RequestDesk::Settings{}};
  StatusBoard status_{"1.2", "office"};
  std::chrono::nanoseconds now_{1s};
  std::vector<WorkerStatus> workers_;
  std::vector<ServiceStatus> services_;
};

TEST_F(StatusBoardTest, TellsOfTheServiceAtOnce) {
  look();
  ASSERT_THAT(services_, SizeIs(1));
  EXPECT_EQ(services_[0].version, "1.2");
  EXPECT_EQ(services_[0].host, "office");
  EXPECT_EQ(services_[0].process, static_cast<std::uint32_t>(getpid()));
  EXPECT_NEAR(services_[0].uptime, 1.1, 1e-9);
  EXPECT_TRUE(services_[0].accepting);
}

TEST_F(StatusBoardTest, LooksTenTimesASecondAtMost) {
  EXPECT_TRUE(status_.update(board_, desk_, now_));
  EXPECT_FALSE(status_.update(board_, desk_, now_ + 99ms));
  EXPECT_TRUE(status_.update(board_, desk_, now_ + 100ms));
}

TEST_F(StatusBoardTest, TellsWhatHasNotChangedAgainFromTimeToTimeOnly) {
  announce(kWorker, 2);
  look();
  look();
  EXPECT_THAT(services_, IsEmpty());
  EXPECT_THAT(workers_, IsEmpty());
  look(2000ms);
  EXPECT_THAT(services_, SizeIs(1));
  EXPECT_THAT(workers_, SizeIs(1));
}

TEST_F(StatusBoardTest, TellsOfAWorkerThatComes) {
  look();
  announce(kWorker, 2);
  look();
  ASSERT_THAT(workers_, SizeIs(1));
  EXPECT_EQ(workers_[0].worker, kWorker.value);
  EXPECT_EQ(workers_[0].host, "hall 3");
  EXPECT_EQ(workers_[0].threads, 2U);
  EXPECT_EQ(workers_[0].standing, "welcome");
  ASSERT_THAT(services_, SizeIs(1));
  EXPECT_EQ(services_[0].workers, 1U);
  EXPECT_EQ(services_[0].threads, 2U);
}

TEST_F(StatusBoardTest, TellsOnceOfAWorkerThatIsLost) {
  announce(kWorker, 2);
  board_.add({1, {}, nullptr}, {{1, {1}, {2}, 1, false}});
  while (const auto out = board_.next_outgoing(now_)) {
    board_.on_published(out->to, Published::kSent, now_);
  }
  look();
  ASSERT_THAT(workers_, SizeIs(1));
  EXPECT_EQ(workers_[0].busy, 1U);
  board_.on_event({kWorker, PeerLost{}}, now_);
  look();
  ASSERT_THAT(workers_, SizeIs(1));
  EXPECT_EQ(workers_[0].standing, "lost");
  EXPECT_EQ(workers_[0].busy, 0U);
  look(2000ms);
  EXPECT_THAT(workers_, IsEmpty());
}

TEST_F(StatusBoardTest, SaysWhyAWorkerGetsNoTasksAndDoesNotCountIt) {
  announce(kWorker, 2, kProtocol + 1);
  look();
  ASSERT_THAT(workers_, SizeIs(1));
  EXPECT_EQ(workers_[0].standing, "refused");
  EXPECT_EQ(workers_[0].text, "it speaks protocol 2; this coordinator speaks 1");
  EXPECT_EQ(services_.at(0).workers, 0U);
  EXPECT_EQ(services_.at(0).threads, 0U);
}

TEST_F(StatusBoardTest, SaysThatNothingIsAcceptedAnyMore) {
  look();
  desk_.drain({now_, 0});
  look();
  ASSERT_THAT(services_, SizeIs(1));
  EXPECT_FALSE(services_[0].accepting);
}

}  // namespace
}  // namespace accord
