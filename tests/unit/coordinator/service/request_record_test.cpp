#include "coordinator/service/request_record.h"

#include <gtest/gtest.h>

#include "common/io/scene_file.h"
#include "common/io/wire/scene_codec.h"
#include "common/planning/random.h"

namespace accord {
namespace {

std::shared_ptr<const Scene> example_scene(const std::string& name) {
  return load_scene(ACCORD_SOURCE_DIR "/scenes/" + name + ".yaml").scene;
}

PlanRequest request_with_everything() {
  PlanRequest request;
  request.id = "order-1";
  request.scene_text = "as it came";
  request.attachments = {{"arm.urdf", "<robot/>"}};
  request.queries = {{"r0", Configuration{1, 2}, std::nullopt}};
  request.method = "cbs-mp";
  request.seed = 77;
  request.solvers = {"composite-prm"};
  request.deadline = 12.5;
  request.priority = -3;
  return request;
}

TEST(RequestRecord, KeepsWhatWasAskedAndTheSceneAsItWasThen) {
  const PlanRequest request = request_with_everything();
  for (const char* name : {"peer-inlet", "carts-6", "panda-four", "depot-map"}) {
    const auto scene = example_scene(name);
    const auto record = decode_record(encode_record(request, *scene));
    ASSERT_TRUE(record) << record.error();
    EXPECT_EQ(encode_scene(*record->scene), encode_scene(*scene)) << name;
    PlanRequest bare = request;
    bare.scene_text.clear();
    bare.attachments.clear();
    bare.queries.clear();  // they are the scene's own by now
    EXPECT_EQ(record->request, bare);
  }
}

TEST(RequestRecord, IsOneSequenceOfBytes) {
  const auto scene = example_scene("peer-inlet");
  const Bytes bytes = encode_record(request_with_everything(), *scene);
  const auto record = decode_record(bytes);
  ASSERT_TRUE(record);
  EXPECT_EQ(encode_record(record->request, *record->scene), bytes);
}

TEST(RequestRecord, ThatIsCutOffSaysSo) {
  const Bytes bytes = encode_record(request_with_everything(), *example_scene("peer-inlet"));
  std::size_t read = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto record = decode_record(BytesView(bytes).first(size));
    if (record) ++read;
    EXPECT_TRUE(record || !record.error().empty()) << size;
  }
  EXPECT_LE(read, 3U) << "what an encoder leaves out at the end may be missing, no more";
}

TEST(RequestRecord, TakesAnyBytes) {
  const Bytes sound = encode_record(request_with_everything(), *example_scene("peer-inlet"));
  RandomStream random(3);
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes = sound;
    for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) {
      bytes[random.below(bytes.size())] = static_cast<Bytes::value_type>(random.below(256));
    }
    if (random.below(4) == 0) bytes.resize(random.below(bytes.size()));
    const auto record = decode_record(bytes);
    if (record) {
      EXPECT_FALSE(record->scene->robots.empty());
    } else {
      EXPECT_FALSE(record.error().empty());
    }
  }
}

TEST(RequestRecord, BelievesNoLengthBeyondItsBytes) {
  Bytes bytes(64, static_cast<Bytes::value_type>(0xff));
  const auto record = decode_record(bytes);
  ASSERT_FALSE(record);
  EXPECT_EQ(record.error(), "it is cut off");
}

}  // namespace
}  // namespace accord
