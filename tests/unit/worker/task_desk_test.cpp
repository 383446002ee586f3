#include "worker/service/task_desk.h"

#include <gtest/gtest.h>

#include <optional>

namespace accord {
namespace {

using std::chrono::milliseconds;
using Time = TaskDesk::Time;

constexpr EndpointId kCoordinator{3};
constexpr EndpointId kOther{4};

class TaskDeskTest : public ::testing::Test {
 protected:
  TaskDeskTest() : desk_(settings()) { scene_.bytes[0] = 1; }

  static TaskDesk::Settings settings() {
    TaskDesk::Settings settings;
    settings.info.threads = 1;
    settings.info.task_bytes = 10;
    settings.info.scene_bytes = 1000;
    return settings;
  }

  void hear(EndpointId from, Message message, Time now = Time(0)) {
    desk_.on_event({from, std::move(message)}, now);
  }
  static Command command(Command::Kind kind) {
    Command command;
    command.kind = kind;
    return command;
  }
  void give(std::uint64_t task, std::size_t bytes = 3) {
    hear(kCoordinator, TaskBatch{1, scene_, {}, {{{task, 0}, Bytes(bytes, 1)}}});
  }
  // All that it has to say, said.
  std::vector<Message> say(Time now = Time(0)) {
    std::vector<Message> said;
    while (const auto out = desk_.next_outgoing(now)) {
      said.push_back(out->message);
      desk_.on_published(Published::kSent, now);
    }
    return said;
  }
  template <class Kind>
  static const Kind* find(const std::vector<Message>& said) {
    for (const Message& message : said) {
      if (const auto* found = std::get_if<Kind>(&message)) return found;
    }
    return nullptr;
  }

  SceneHash scene_;
  TaskDesk desk_;
};

TEST_F(TaskDeskTest, AnnouncesItselfUntilItIsWelcomedAndThenSaysThatItIsAlive) {
  desk_.on_time(Time(0));
  EXPECT_TRUE(find<Announcement>(say()));
  desk_.on_time(milliseconds(100));
  EXPECT_TRUE(find<Announcement>(say(milliseconds(100))));
  hear(kCoordinator, command(Command::Kind::kWelcome), milliseconds(150));
  desk_.on_time(milliseconds(200));
  const auto said = say(milliseconds(200));
  EXPECT_FALSE(find<Announcement>(said));
  EXPECT_TRUE(find<Heartbeat>(said));
}

TEST_F(TaskDeskTest, AsksForTheSceneThatItLacksAndBeginsWhenItIsReady) {
  hear(kCoordinator, command(Command::Kind::kWelcome));
  give(1);
  EXPECT_TRUE(find<SceneRequest>(say()));
  EXPECT_FALSE(desk_.next_job(Time(0)));
  desk_.on_scene_ready(scene_);
  const auto job = desk_.next_job(Time(0));
  ASSERT_TRUE(job);
  EXPECT_EQ(job->key.task, 1U);
  give(2);
  EXPECT_FALSE(desk_.next_job(Time(0))) << "its only thread is busy";
  desk_.on_ended(*job, {});
  EXPECT_TRUE(find<ResultBatch>(say()));
  EXPECT_TRUE(desk_.next_job(Time(0)));
}

TEST_F(TaskDeskTest, TakesATaskOnceThatComesTwice) {
  desk_.on_scene_ready(scene_);
  give(1);
  give(1);
  ASSERT_TRUE(desk_.next_job(Time(0)));
  give(1);
  EXPECT_TRUE(desk_.take_revoked().empty());
  desk_.leave();
  EXPECT_FALSE(find<ResultBatch>(say())) << "nothing waits";
}

TEST_F(TaskDeskTest, TakesWorkThatOvertakesTheWelcomeButNoneFromStrangers) {
  desk_.on_scene_ready(scene_);
  give(1);
  EXPECT_EQ(desk_.coordinator(), kCoordinator);
  hear(kOther, TaskBatch{1, scene_, {}, {{{9, 0}, Bytes(3, 1)}}});
  ASSERT_TRUE(desk_.next_job(Time(0)));
  desk_.leave();
  EXPECT_FALSE(find<ResultBatch>(say())) << "the stranger's task waits here";
}

TEST_F(TaskDeskTest, RefusesWhatIsTooLarge) {
  hear(kCoordinator, command(Command::Kind::kWelcome));
  give(1, 11);
  const auto said = say();
  const auto* results = find<ResultBatch>(said);
  ASSERT_TRUE(results);
  EXPECT_EQ(results->results[0].outcome, ResultItem::Outcome::kRefused);
}

TEST_F(TaskDeskTest, SaysNothingOfWhatWasRevoked) {
  desk_.on_scene_ready(scene_);
  give(1);
  const auto job = desk_.next_job(Time(0));
  ASSERT_TRUE(job);
  Command revoke = command(Command::Kind::kRevoke);
  revoke.tasks = {job->key};
  hear(kCoordinator, revoke);
  EXPECT_EQ(desk_.take_revoked(), std::vector<TaskKey>{job->key});
  say();
  desk_.on_ended(*job, {});
  EXPECT_FALSE(find<ResultBatch>(say()));
}

TEST_F(TaskDeskTest, DropsACoordinatorThatFallsSilentAndAnnouncesItselfAnew) {
  desk_.on_scene_ready(scene_);
  hear(kCoordinator, command(Command::Kind::kWelcome));
  give(1);
  const auto job = desk_.next_job(Time(0));
  ASSERT_TRUE(job);
  desk_.on_time(milliseconds(500));
  EXPECT_FALSE(desk_.coordinator());
  EXPECT_EQ(desk_.take_revoked().size(), 1U);
  EXPECT_TRUE(find<Announcement>(say(milliseconds(500))));
  desk_.on_ended(*job, {});
  EXPECT_FALSE(find<ResultBatch>(say(milliseconds(500))));
}

TEST_F(TaskDeskTest, HandsBackWhatHasNotBegunWhenItLeaves) {
  desk_.on_scene_ready(scene_);
  give(1);
  give(2);
  const auto job = desk_.next_job(Time(0));
  ASSERT_TRUE(job);
  say();
  desk_.leave();
  desk_.on_time(milliseconds(100));
  auto said = say(milliseconds(100));
  const auto* results = find<ResultBatch>(said);
  ASSERT_TRUE(results);
  EXPECT_EQ(results->results[0].key.task, 2U);
  EXPECT_EQ(results->results[0].outcome, ResultItem::Outcome::kHandedBack);
  const auto* announcement = find<Announcement>(said);
  ASSERT_TRUE(announcement);
  EXPECT_TRUE(announcement->leaving);
  EXPECT_FALSE(desk_.is_idle()) << "one task runs";
  desk_.on_ended(*job, {});
  EXPECT_TRUE(find<ResultBatch>(say(milliseconds(100))));
  EXPECT_TRUE(desk_.is_idle());
}

}  // namespace
}  // namespace accord
