// What the journal keeps of an accepted request: what was asked, and the scene as it was then, so
// that a restart plans the same, whatever has become of the files it came from.
// Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"
#include "common/model/plan_request.h"
#include "common/model/scene.h"

namespace accord {

struct RequestRecord {
  PlanRequest request;  // without the scene's text and files
  std::shared_ptr<const Scene> scene;
};

// A request that nothing is wrong with.
struct ReadyRequest {
  std::shared_ptr<const Scene> scene;
  Bytes record;
};

Bytes encode_record(const PlanRequest& request, const Scene& scene);
// Or what is wrong with the bytes, as a sentence.
tl::expected<RequestRecord, std::string> decode_record(BytesView bytes);

}  // namespace accord
