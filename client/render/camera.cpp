#include "client/render/camera.h"

namespace accord {
namespace {

constexpr double kMaxPanelHeight = 880;  // pixels, of all panels together
constexpr double kPanelGap = 24;         // pixels

void include_robot(const Scene& scene, const DrawnRobot& drawn, View view, Extent& extent) {
  const auto include = [&](ConfigurationView q) {
    for (const Outline& o : robot_outlines(drawn.robot, q, view, scene.planar)) {
      extent.include(o);
    }
  };
  include(drawn.robot.start);
  include(drawn.robot.goal);
  if (drawn.path == nullptr) return;
  for (std::size_t i = 0; i < drawn.path->size(); ++i) include(drawn.path->configuration(i));
}

Extent in_sight(const Scene& scene, const std::vector<DrawnRobot>& robots, View view) {
  Extent extent;
  if (scene.bounds) {
    extent.include(projected(view, scene.bounds->min));
    extent.include(projected(view, scene.bounds->max));
    return extent;
  }
  for (const Obstacle& obstacle : scene.obstacles) {
    extent.include(outline(obstacle.shape, obstacle.pose, view, scene.planar));
  }
  for (const DrawnRobot& drawn : robots) include_robot(scene, drawn, view, extent);
  if (extent.empty()) extent.include(Vec2::Zero(), 1);
  const double margin = 0.04 * extent.size().maxCoeff();
  extent.low.array() -= margin;
  extent.high.array() += margin;
  return extent;
}

}  // namespace

std::vector<Camera> lay_out(const Scene& scene, const std::vector<DrawnRobot>& robots, Vec2 corner,
                            double width) {
  std::vector<Camera> cameras;
  cameras.push_back({View::kTop, in_sight(scene, robots, View::kTop)});
  if (!scene.planar) cameras.push_back({View::kSide, in_sight(scene, robots, View::kSide)});
  double widest = 0;
  double total_height = 0;
  for (const Camera& camera : cameras) {
    widest = std::max(widest, camera.extent.size().x());
    total_height += camera.extent.size().y();
  }
  const double scale = std::min(width / widest, kMaxPanelHeight / std::max(total_height, 1e-9));
  double y = corner.y();
  for (Camera& camera : cameras) {
    camera.scale = scale;
    camera.corner = {corner.x() + (width - camera.size().x()) / 2, y};
    y += camera.size().y() + kPanelGap;
  }
  return cameras;
}

}  // namespace accord
