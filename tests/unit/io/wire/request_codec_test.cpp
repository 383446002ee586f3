#include "common/io/wire/request_codec.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "common/io/limits.h"
#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;

TEST(RequestCodec, BringsRandomRequestsBackToTheBit) {
  RandomStream random(6);
  for (int i = 0; i < 2'000; ++i) {
    const PlanRequest request = random_request(random);
    const Bytes bytes = encode_request(request);
    const auto decoded = decode_request(bytes);
    ASSERT_TRUE(decoded) << decoded.error();
    ASSERT_EQ(*decoded, request);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(decoded->deadline),
              std::bit_cast<std::uint64_t>(request.deadline));
    ASSERT_EQ(encode_request(*decoded), bytes);
  }
}

TEST(RequestCodec, KeepsDefaults) {
  PlanRequest request;
  request.id = "a";
  EXPECT_EQ(decode_request(encode_request(request)), request);
}

TEST(RequestCodec, KeepsTheLeastAndTheGreatest) {
  PlanRequest request;
  request.id = std::string(limits::kRequestIdBytes, 'z');
  request.seed = std::numeric_limits<std::uint64_t>::max();
  request.priority = std::numeric_limits<std::int32_t>::min();
  request.deadline = limits::kDeadline;
  EXPECT_EQ(decode_request(encode_request(request)), request);
  request.seed = 0;
  request.priority = std::numeric_limits<std::int32_t>::max();
  request.deadline = -0.0;
  EXPECT_EQ(decode_request(encode_request(request)), request);
}

TEST(RequestCodec, TakesAsMuchAsLimitsAllow) {
  PlanRequest request;
  request.id = "large";
  request.scene_text.resize(limits::kSceneBytes, '#');
  for (std::size_t i = 0; i < limits::kAttachments; ++i) {
    request.attachments.push_back(
        {std::to_string(i), std::string(limits::kAttachmentBytes / limits::kAttachments, 'x')});
  }
  for (std::size_t i = 0; i < limits::kRobots; ++i) {
    request.queries.push_back(
        {"robot" + std::to_string(i), Configuration{1, 2, 3}, Configuration{4, 5, 6}});
  }
  request.solvers.assign(limits::kSolvers, "composite-prm");
  const auto decoded = decode_request(encode_request(request));
  ASSERT_TRUE(decoded) << decoded.error();
  EXPECT_EQ(*decoded, request);
}

TEST(RequestHash, TellsEveryFieldApart) {
  PlanRequest request;
  request.id = "a";
  request.attachments = {{"n", "c"}};
  request.queries = {{"r", Configuration{1}, {}}};
  const RequestHash hash = request_hash(request);
  const auto differs = [&](auto&& change) {
    PlanRequest other = request;
    change(other);
    return request_hash(other) != hash;
  };
  EXPECT_FALSE(differs([](PlanRequest&) {}));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.id = "b"; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.scene_text = "s"; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.scene_name = "s"; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.attachments = {{"nc", ""}}; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.queries[0] = {"r", {}, Configuration{1}}; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.queries[0].start = Configuration{-1}; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.method = "cbs-mp"; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.seed = 2; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.solvers = {"arc"}; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.deadline = 1; }));
  EXPECT_TRUE(differs([](PlanRequest& r) { r.priority = 1; }));
}

}  // namespace
}  // namespace accord
