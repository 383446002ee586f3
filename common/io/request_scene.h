// From what a fleet manager asks for to the scene to plan: everything about a request is checked
// before it is accepted, so that nothing which was accepted is refused later.
//
// Made for hostile input: time and memory are bounded by limits.h whatever a request holds. Nothing
// throws but std::bad_alloc. Thread safe.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/io/limits.h"
#include "common/io/request_fault.h"
#include "common/model/plan_request.h"
#include "common/model/scene.h"

namespace accord {

// What a service takes, within limits.h, and what there is to choose from.
struct RequestLimits {
  std::size_t robots = limits::kRobots;
  std::size_t bytes = limits::kRequestBytes;  // of a request in all
  std::vector<std::string> methods;
  std::vector<std::string> solvers;
};

// The request's scene, its own starts and goals in place; or the first thing that is wrong with the
// request, in this order: its id, its size, its options, its scene, its queries. Files that the
// scene's text names are the request's attachments. `stored_scenes` is the folder of NAME.yaml,
// which name files as scene files do; empty: there are none.
tl::expected<std::shared_ptr<const Scene>, RequestFault> load_request(
    const PlanRequest& request, const std::filesystem::path& stored_scenes,
    const RequestLimits& limits);

}  // namespace accord
