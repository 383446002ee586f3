#include "common/io/wire/task_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/io/limits.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;
using ::testing::StartsWith;

class TaskRecordCodec : public ::testing::Test {
 protected:
  TaskRecordCodec() : scene_(small_scene()) {
    RandomStream random(5);
    record_ = {encode_scene(*scene_), encode_hierarchy({"prioritized-query", "magic"}),
               encode_subproblem(random_subproblem(random, *scene_)), "its workers were lost"};
  }

  std::string fault() const {
    const auto task = decode_task_record(encode_task_record(record_));
    return task ? "none" : task.error();
  }

  std::shared_ptr<const Scene> scene_;
  TaskRecord record_;
};

TEST_F(TaskRecordCodec, BringsTasksBackToTheBit) {
  const Bytes bytes = encode_task_record(record_);
  const auto task = decode_task_record(bytes);
  ASSERT_TRUE(task) << task.error();
  EXPECT_EQ(task->solvers, (std::vector<std::string>{"prioritized-query", "magic"}));
  EXPECT_EQ(task->why, "its workers were lost");
  EXPECT_EQ(encode_task_record({encode_scene(*task->scene), encode_hierarchy(task->solvers),
                                encode_subproblem(task->subproblem), task->why}),
            bytes);
}

TEST_F(TaskRecordCodec, KeepsWhateverAWorkerHasSaid) {
  record_.why = "\x1b[2J caf\xc3\xa9\xff" + std::string(1, '\0') + std::string(10'000, 'x');
  const auto task = decode_task_record(encode_task_record(record_));
  ASSERT_TRUE(task) << task.error();
  EXPECT_THAT(task->why, StartsWith("?[2J caf\xc3\xa9??xxx"));
  EXPECT_EQ(task->why.size(), limits::kWhyBytes);
}

TEST_F(TaskRecordCodec, SaysWhichPartIsWrong) {
  const TaskRecord sound = record_;
  record_.scene.pop_back();
  EXPECT_THAT(fault(), StartsWith("scene: "));
  record_ = sound;
  record_.hierarchy.clear();
  EXPECT_THAT(fault(), StartsWith("hierarchy: "));
  record_ = sound;
  record_.subproblem.pop_back();
  EXPECT_THAT(fault(), StartsWith("subproblem: "));
}

TEST_F(TaskRecordCodec, TellsOtherFilesFromItsOwn) {
  EXPECT_EQ(decode_task_record({}).error(), "not a recorded task");
  EXPECT_EQ(decode_task_record(record_.scene).error(), "not a recorded task");
}

TEST_F(TaskRecordCodec, RefusesWhatIsCutShortOrChangedOrItIsSound) {
  Bytes bytes = encode_task_record(record_);
  const std::size_t all_but_why = bytes.size() - record_.why.size() - 2;
  for (std::size_t size = 0; size < all_but_why; ++size) {
    EXPECT_FALSE(decode_task_record(BytesView(bytes).first(size))) << size;
  }
  for (std::uint8_t& byte : bytes) {
    const std::uint8_t before = byte;
    for (const int change : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      byte = static_cast<std::uint8_t>(before ^ change);
      const auto task = decode_task_record(bytes);
      EXPECT_TRUE(task || !task.error().empty());
    }
    byte = before;
  }
}

}  // namespace
}  // namespace accord
