// Simple polygons from lists of points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/io/fields.h"
#include "common/model/shape.h"

namespace accord {

// Gaps that a polygon's outline must keep from itself, so that no rounding makes it touch itself.
inline constexpr double kOutlineGap = 1e-7;    // m
inline constexpr double kShortestEdge = 1e-6;  // m

// Why the points do not make a simple polygon with an inside, in words; nullopt where they do.
// Either direction is fine. Takes time quadratic in the number of points.
std::optional<std::string> outline_fault(const std::vector<Vec2>& points);

// Positive where the points go round counter-clockwise. Requires: a simple polygon.
double signed_area(const std::vector<Vec2>& points);

// [[x, y], ...], at least three; the result is counter-clockwise.
std::optional<Polygon> read_polygon(const Value& value, Faults& faults);

}  // namespace accord
