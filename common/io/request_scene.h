#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "common/model/plan_request.h"
#include "common/model/request_state.h"
#include "common/model/scene.h"
namespace accord {
struct RequestLimits {
  std::size_t bytes = 16 << 20;
  std::size_t robots = 10000;
  std::vector<std::string> methods, solvers;
};
struct RequestFault {
  Rejection reason;
  std::string field, text;
};
tl::expected<std::shared_ptr<const Scene>, RequestFault> load_request(
    const PlanRequest& request, const std::filesystem::path& scenes, const RequestLimits& limits);
}  // namespace accord
