#include "client/render/labels.h"

#include <fmt/format.h>

#include <algorithm>

namespace accord {
namespace {

// Of bold sans-serif letters, in parts of their size; viewers choose the font, so it is a guess.
constexpr double kLetterWidth = 0.62;
constexpr double kBaseline = 0.35;  // below the middle

double width_of(const std::string& name) {
  return kLetterWidth * static_cast<double>(name.size());
}

}  // namespace

void Labels::write(const Vec2& centre, const std::string& name, double size,
                   std::string_view attributes) {
  const Vec2 half = Vec2(width_of(name), 1) * size / 2;
  const Box box{centre - half, centre + half};
  const bool collides = std::ranges::any_of(taken_, [&](const Box& other) {
    return (box.low.array() < other.high.array()).all() &&
           (other.low.array() < box.high.array()).all();
  });
  if (collides) return;
  taken_.push_back(box);
  svg_.text(centre + Vec2(0, size * kBaseline), name,
            fmt::format("font-size=\"{:.1f}\" {}", size, attributes));
}

double Labels::size_for(const std::string& name, double room) {
  return room / width_of(name);
}

}  // namespace accord
