#include "coordinator/service/request_record.h"

#include <cstdint>

#include "common/io/wire/request_codec.h"
#include "common/io/wire/scene_codec.h"

namespace accord {
namespace {

constexpr std::size_t kLengthBytes = 4;  // of the request, the least significant byte first

}  // namespace

Bytes encode_record(const PlanRequest& request, const Scene& scene) {
  PlanRequest bare = request;
  bare.scene_text.clear();
  bare.attachments.clear();
  bare.queries.clear();  // the scene has them
  const Bytes asked = encode_request(bare);
  const Bytes where = encode_scene(scene);
  Bytes out;
  out.reserve(kLengthBytes + asked.size() + where.size());
  for (std::size_t i = 0; i < kLengthBytes; ++i) {
    out.push_back(static_cast<Bytes::value_type>((asked.size() >> (8 * i)) & 0xffU));
  }
  out.insert(out.end(), asked.begin(), asked.end());
  out.insert(out.end(), where.begin(), where.end());
  return out;
}

tl::expected<RequestRecord, std::string> decode_record(BytesView bytes) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < kLengthBytes && i < bytes.size(); ++i) {
    length |= std::size_t{static_cast<std::uint8_t>(bytes[i])} << (8 * i);
  }
  if (bytes.size() < kLengthBytes || length > bytes.size() - kLengthBytes) {
    return tl::unexpected(std::string("it is cut off"));
  }
  auto request = decode_request(bytes.subspan(kLengthBytes, length));
  if (!request) return tl::unexpected(std::move(request.error()));
  auto scene = decode_scene(bytes.subspan(kLengthBytes + length));
  if (!scene) return tl::unexpected(std::move(scene.error()));
  return RequestRecord{std::move(*request), std::move(*scene)};
}

}  // namespace accord
