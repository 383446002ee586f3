// A request's own starts and goals, for a scene that has others.
#pragma once

#include <memory>
#include <tl/expected.hpp>
#include <vector>

#include "common/io/request_fault.h"
#include "common/model/plan_request.h"
#include "common/model/scene.h"

namespace accord {

// The scene with the queries' starts and goals in place of its own, which have passed the same
// checks; or what is wrong with them, each fault with the query that is to blame (kBadQuery).
// Thread safe; nothing throws but std::bad_alloc. Requires: the scene passed io's checks.
tl::expected<std::shared_ptr<const Scene>, RequestFault> with_queries(
    std::shared_ptr<const Scene> scene, const std::vector<PlanRequest::Query>& queries);

}  // namespace accord
