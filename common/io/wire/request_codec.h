// What a fleet manager asks for, to bytes and back: as the journal keeps it.
//
// Canonical: one value, one sequence of bytes, on every machine; their SHA-256 tells whether two
// requests ask for the same. Thread safe. Nothing throws but std::bad_alloc, and request_hash() as
// hash_of().
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"
#include "common/io/wire/scene_hash.h"
#include "common/model/plan_request.h"

namespace accord {

// Requires: at most some 2 GB in all, which Protobuf ends at.
Bytes encode_request(const PlanRequest& request);

// The request, bit for bit, or a sentence that says which field is wrong and what was expected, as
// in "queries[2].start: expected 1 to 200 numbers, not 0". Takes any bytes: a request that comes
// back keeps the limits of limits.h, and its numbers are finite. Whether its scene is one, and what
// it asks for exists, is for load_request() (request_scene.h) to say.
tl::expected<PlanRequest, std::string> decode_request(BytesView bytes);

// hash_of(encode_request(request)).
RequestHash request_hash(const PlanRequest& request);

}  // namespace accord
