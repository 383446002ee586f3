// Writes a small SVG document: shapes in pixels, y down, numbers to a tenth of a pixel.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "common/model/shape.h"

namespace accord {

// Text that XML would take for markup, escaped.
std::string escaped(std::string_view text);

class Svg {
 public:
  Svg(double width, double height);

  // Elements added until close() share `attributes`, which are written as given.
  void open(std::string_view attributes);
  void close();

  // Names a path that open() can clip its elements to: clip-path="url(#id)".
  void define_clip(std::string_view id, std::string_view data);

  void rectangle(Vec2 corner, Vec2 size, std::string_view attributes = {});
  void circle(Vec2 centre, double radius, std::string_view attributes = {});
  void text(Vec2 at, std::string_view words, std::string_view attributes = {});
  void path(std::string_view data, std::string_view attributes = {});

  // The finished document. Requires: every open() was closed.
  std::string str() const;

 private:
  double width_;
  double height_;
  std::string body_;
};

// Data for Svg::path: a line through the points, closed to a polygon or not; successive points on
// the same tenth of a pixel count as one.
std::string line_data(std::span<const Vec2> points, bool closed);

}  // namespace accord
