#include "common/io/request_scene.h"

#include "common/io/scene_file.h"
namespace accord {
tl::expected<std::shared_ptr<const Scene>, RequestFault> load_request(
    const PlanRequest& request, const std::filesystem::path& scenes, const RequestLimits&) {
  auto r = parse_scene(request.scene_text, "scene", scenes);
  if (!r.scene)
    return tl::unexpected(RequestFault{Rejection::kBadScene, "scene", to_string(r.faults.front())});
  return r.scene;
}
}  // namespace accord
