// From metres in the world to pixels in the panels of a picture.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "client/render/drawn_robot.h"
#include "client/render/outline.h"

namespace accord {

// An axis-parallel rectangle in metres; empty until something is put in.
struct Extent {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = Vec2::Constant(-std::numeric_limits<double>::infinity());

  bool empty() const { return low.x() > high.x(); }
  Vec2 size() const { return high - low; }
  void include(const Vec2& point, double radius = 0) {
    low = low.cwiseMin((point.array() - radius).matrix());
    high = high.cwiseMax((point.array() + radius).matrix());
  }
  void include(const Outline& outline) {
    for (const Vec2& point : outline.points) include(point, outline.radius);
  }
};

struct Camera {
  View view = View::kTop;
  Extent extent;      // what is in sight
  double scale = 1;   // pixels per metre
  Vec2 corner{0, 0};  // the panel's upper left corner, pixels

  Vec2 size() const { return extent.size() * scale; }
  Vec2 pixels(const Vec2& p) const {
    return corner + Vec2(p.x() - extent.low.x(), extent.high.y() - p.y()) * scale;
  }
  std::vector<Vec2> pixels(std::span<const Vec2> points) const {
    std::vector<Vec2> out;
    out.reserve(points.size());
    for (const Vec2& point : points) out.push_back(pixels(point));
    return out;
  }
};

// The panels that show the scene, all at one scale, one below the other, centred in the given width
// (pixels) below `corner`: from above; a spatial scene from the side as well.
std::vector<Camera> lay_out(const Scene& scene, const std::vector<DrawnRobot>& robots, Vec2 corner,
                            double width);

}  // namespace accord
