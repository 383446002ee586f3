#include "client/render/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace accord {
namespace {

// In tenths of a pixel, so that what is written and what is compared are the same.
struct Tenths {
  long x;
  long y;

  explicit Tenths(const Vec2& v) : x(std::lround(v.x() * 10)), y(std::lround(v.y() * 10)) {}
  bool operator==(const Tenths&) const = default;
};

std::string shown(long tenths) {
  const long whole = std::labs(tenths) / 10;
  const long rest = std::labs(tenths) % 10;
  std::string out = tenths < 0 ? "-" : "";
  if (whole != 0 || rest == 0) out += std::to_string(whole);
  if (rest != 0) out += '.' + std::to_string(rest);
  return out;
}

std::string shown(double pixels) {
  return shown(std::lround(pixels * 10));
}

std::string spaced(std::string_view attributes) {
  return attributes.empty() ? "" : ' ' + std::string(attributes);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::open(std::string_view attributes) {
  body_ += fmt::format("<g {}>\n", attributes);
}

void Svg::close() {
  body_ += "</g>\n";
}

void Svg::define_clip(std::string_view id, std::string_view data) {
  body_ += fmt::format("<clipPath id=\"{}\"><path d=\"{}\"/></clipPath>\n", id, data);
}

void Svg::rectangle(Vec2 corner, Vec2 size, std::string_view attributes) {
  body_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", shown(corner.x()),
                  shown(corner.y()), shown(size.x()), shown(size.y()), spaced(attributes));
}

void Svg::circle(Vec2 centre, double radius, std::string_view attributes) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", shown(centre.x()),
                       shown(centre.y()), shown(radius), spaced(attributes));
}

void Svg::text(Vec2 at, std::string_view words, std::string_view attributes) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", shown(at.x()), shown(at.y()),
                       spaced(attributes), escaped(words));
}

void Svg::path(std::string_view data, std::string_view attributes) {
  if (data.empty()) return;
  body_ += fmt::format("<path d=\"{}\"{}/>\n", data, spaced(attributes));
}

std::string Svg::str() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"Inter, Helvetica, Arial, 'DejaVu Sans', "
      "sans-serif\">\n{2}</svg>\n",
      shown(width_), shown(height_), body_);
}

std::string line_data(std::span<const Vec2> points, bool closed) {
  std::string out;
  std::size_t written = 0;
  Tenths last{Vec2::Zero()};
  for (const Vec2& point : points) {
    const Tenths here(point);
    if (written > 0 && here == last) continue;
    out += written == 0 ? 'M' : written == 1 ? 'L' : ' ';
    out += shown(here.x) + ' ' + shown(here.y);
    last = here;
    ++written;
  }
  if (written < 2) return {};
  if (closed) out += 'Z';
  return out;
}

}  // namespace accord
