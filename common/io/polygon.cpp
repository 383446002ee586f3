#include "common/io/polygon.h"

#include <algorithm>
#include <cmath>

#include "common/io/words.h"

namespace accord {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double point_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double s = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - (a + s * along)).norm();
}

bool properly_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  return ((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0));
}

bool boxes_apart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return (a.cwiseMax(b).array() + kOutlineGap < c.cwiseMin(d).array()).any() ||
         (c.cwiseMax(d).array() + kOutlineGap < a.cwiseMin(b).array()).any();
}

bool segments_touch(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (boxes_apart(a, b, c, d)) return false;
  return properly_cross(a, b, c, d) ||
         std::min({point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b),
                   point_to_segment(d, a, b)}) < kOutlineGap;
}

// Whether the edges a-b and b-c fold back onto each other.
bool folds_back(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).dot(c - b) < 0 &&
         std::min(point_to_segment(a, b, c), point_to_segment(c, a, b)) < kOutlineGap;
}

std::string edge_in_words(std::size_t i, std::size_t count) {
  return "from point " + std::to_string(i) + " to " + std::to_string((i + 1) % count);
}

std::optional<std::string> touching_edges(const std::vector<Vec2>& points) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % count];
    if (folds_back(a, b, points[(i + 2) % count])) {
      return "the edges at point " + std::to_string((i + 1) % count) + " fold back onto each other";
    }
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;  // neighbours
      if (segments_touch(a, b, points[j], points[(j + 1) % count])) {
        return "intersects itself: the edge " + edge_in_words(i, count) + " touches the edge " +
               edge_in_words(j, count);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

double signed_area(const std::vector<Vec2>& points) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    twice += cross(points[i] - points[0], points[i + 1] - points[0]);
  }
  return twice / 2;
}

std::optional<std::string> outline_fault(const std::vector<Vec2>& points) {
  const std::size_t count = points.size();
  if (count < 3) {
    return "expected at least three points, not " + std::to_string(count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if ((points[next] - points[i]).norm() >= kShortestEdge) continue;
    if (next == 0) return "the last point repeats the first; leave it out";
    return "points " + std::to_string(i) + " and " + std::to_string(next) + " coincide";
  }
  if (auto fault = touching_edges(points)) return fault;
  if (std::abs(signed_area(points)) < kShortestEdge * kShortestEdge) {
    return "encloses no area";
  }
  return std::nullopt;
}

std::optional<Polygon> read_polygon(const Value& value, Faults& faults) {
  if (!expect_list(value, "points [x, y]", faults)) return std::nullopt;
  if (value.size() > limits::kPolygonVertices) {
    fault_at(value,
             "a polygon of " + std::to_string(value.size()) + " points; expected at most " +
                 std::to_string(limits::kPolygonVertices),
             faults);
    return std::nullopt;
  }
  Polygon polygon;
  bool sound = true;
  for (const Value item : value) {
    const auto point = read_numbers(item, {2}, "a point [x, y]", kCoordinateRange, faults);
    sound = sound && point;
    if (point) polygon.vertices.emplace_back((*point)[0], (*point)[1]);
  }
  if (!sound) return std::nullopt;
  if (const auto fault = outline_fault(polygon.vertices)) {
    fault_at(value, *fault, faults);
    return std::nullopt;
  }
  if (signed_area(polygon.vertices) < 0) std::ranges::reverse(polygon.vertices);
  return polygon;
}

}  // namespace accord
