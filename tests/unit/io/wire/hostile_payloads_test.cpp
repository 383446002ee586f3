// Bytes from anywhere are refused with a sentence or decoded to a value that is sound; they never
// crash, and never make the decoder allocate by a number that it has not checked. (The sanitizers
// run these tests, too.)
#include <gtest/gtest.h>

#include "common/geometry/collision_world.h"
#include "common/io/wire/request_codec.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;

class HostilePayload : public testing::Test {
 protected:
  HostilePayload() : scene_(small_scene()) {
    RandomStream random(5);
    subproblem_ = random_subproblem(random, *scene_);
    resolution_ = random_resolution(random, subproblem_);
    while (!resolution_.solved) resolution_ = random_resolution(random, subproblem_);
    scene_bytes_ = encode_scene(*scene_);
    subproblem_bytes_ = encode_subproblem(subproblem_);
    resolution_bytes_ = encode_resolution(resolution_);
    PlanRequest request;
    while (request.queries.size() < 3 || request.attachments.size() < 2 ||
           request.solvers.empty()) {
      request = random_request(random);
    }
    request_bytes_ = encode_request(request);
  }

  // Whether they decode. What does must be worth something: a world can be built of it, and it goes
  // round the wire as any other.
  bool try_scene(BytesView bytes) const {
    const auto decoded = decode_scene(bytes);
    if (!decoded) {
      EXPECT_FALSE(decoded.error().empty());
      return false;
    }
    const CollisionWorld world(*decoded, 1e-6);
    const auto again = decode_scene(encode_scene(**decoded));
    EXPECT_TRUE(again);
    return true;
  }

  bool try_subproblem(BytesView bytes) const {
    const auto decoded = decode_subproblem(bytes, *scene_);
    EXPECT_TRUE(decoded || !decoded.error().empty());
    EXPECT_TRUE(!decoded || decode_subproblem(encode_subproblem(*decoded), *scene_));
    return decoded.has_value();
  }

  bool try_resolution(BytesView bytes) const {
    const auto decoded = decode_resolution(bytes, *scene_, subproblem_);
    EXPECT_TRUE(decoded || !decoded.error().empty());
    return decoded.has_value();
  }

  static bool try_request(BytesView bytes) {
    const auto decoded = decode_request(bytes);
    EXPECT_TRUE(decoded || !decoded.error().empty());
    if (!decoded) return false;
    const auto again = decode_request(encode_request(*decoded));
    EXPECT_TRUE(again && *again == *decoded);
    return true;
  }

  template <typename Try>
  static void flip_every_byte(Bytes bytes, const std::vector<int>& changes, const Try& attempt) {
    for (std::uint8_t& byte : bytes) {
      const std::uint8_t before = byte;
      for (const int change : changes) {
        byte = static_cast<std::uint8_t>(before ^ change);
        attempt(bytes);
      }
      byte = before;
    }
  }

  std::shared_ptr<const Scene> scene_;
  Subproblem subproblem_;
  Resolution resolution_;
  Bytes scene_bytes_;
  Bytes subproblem_bytes_;
  Bytes resolution_bytes_;
  Bytes request_bytes_;
};

std::vector<int> single_bits_and_all() {
  return {1, 2, 4, 8, 16, 32, 64, 128, 255};
}

TEST_F(HostilePayload, CutShortAtAnyLengthIsRefused) {
  for (std::size_t size = 0; size < scene_bytes_.size(); ++size) {
    // A whole scene but for its last robots is a scene.
    try_scene(BytesView(scene_bytes_).first(size));
  }
  for (std::size_t size = 0; size < subproblem_bytes_.size(); ++size) {
    EXPECT_FALSE(try_subproblem(BytesView(subproblem_bytes_).first(size))) << size;
  }
  EXPECT_FALSE(try_scene({}));
  EXPECT_FALSE(try_scene(BytesView(scene_bytes_).first(scene_bytes_.size() - 1)));
  for (std::size_t size = 0; size < resolution_bytes_.size(); ++size) {
    try_resolution(BytesView(resolution_bytes_).first(size));
  }
  for (std::size_t size = 0; size < request_bytes_.size(); ++size) {
    try_request(BytesView(request_bytes_).first(size));
  }
  EXPECT_FALSE(try_request({}));
}

TEST_F(HostilePayload, WithAnyByteChangedIsRefusedOrSound) {
  flip_every_byte(scene_bytes_, single_bits_and_all(), [&](BytesView b) { try_scene(b); });
  flip_every_byte(subproblem_bytes_, single_bits_and_all(),
                  [&](BytesView b) { try_subproblem(b); });
  flip_every_byte(resolution_bytes_, single_bits_and_all(),
                  [&](BytesView b) { try_resolution(b); });
  flip_every_byte(request_bytes_, single_bits_and_all(), [&](BytesView b) { try_request(b); });
}

TEST_F(HostilePayload, OfRandomBytesIsRefused) {
  RandomStream random(11);
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes(1 + random.below(200));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
    EXPECT_FALSE(try_scene(bytes));
    EXPECT_FALSE(try_subproblem(bytes));
    EXPECT_FALSE(try_request(bytes));
    try_resolution(bytes);
  }
}

TEST_F(HostilePayload, WithPiecesOfOthersIsRefusedOrSound) {
  RandomStream random(12);
  for (int i = 0; i < 5'000; ++i) {
    Bytes bytes = scene_bytes_;
    for (std::size_t k = random.below(4) + 1; k > 0; --k) {
      const std::size_t from = random.below(bytes.size());
      const std::size_t to = random.below(bytes.size());
      const std::size_t size =
          random.below(std::min<std::size_t>(40, bytes.size() - std::max(from, to)));
      std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(from), size,
                  bytes.begin() + static_cast<std::ptrdiff_t>(to));
    }
    try_scene(bytes);
    try_subproblem(bytes);
    try_resolution(bytes);
    try_request(bytes);
  }
}

TEST_F(HostilePayload, ThatAnnouncesMoreThanItHoldsIsRefused) {
  // Field 1, length 2^31 - 1 and 2^32 - 1, then nothing.
  for (const Bytes& length :
       {Bytes{0x0a, 0xff, 0xff, 0xff, 0xff, 0x07}, Bytes{0x0a, 0xff, 0xff, 0xff, 0xff, 0x0f}}) {
    EXPECT_FALSE(try_scene(length));
    EXPECT_FALSE(try_subproblem(length));
    EXPECT_FALSE(try_resolution(length));
    EXPECT_FALSE(try_request(length));
  }
}

TEST_F(HostilePayload, OfMillionsOfEmptyPartsIsRefusedBeforeItIsParsed) {
  // Obstacles, meshes, tasks, paths and queries of no bytes: two each on the wire, a hundred and
  // more parsed.
  for (const std::uint8_t field : {std::uint8_t{8}, std::uint8_t{6}, std::uint8_t{5}}) {
    Bytes bytes;
    for (int i = 0; i < 4'000'000; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(field << 3U | 2U));
      bytes.push_back(0);
    }
    EXPECT_FALSE(try_scene(bytes));
    EXPECT_FALSE(try_subproblem(bytes));
    EXPECT_FALSE(try_resolution(bytes));
    EXPECT_FALSE(try_request(bytes));
  }
}

}  // namespace
}  // namespace accord
