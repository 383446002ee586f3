#include "client/render/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace accord {
namespace {

constexpr std::array<const char*, 10> kFirst = {"#2f6fde", "#e0572a", "#1d9a6c", "#9c4fd0",
                                                "#d8a013", "#d63a77", "#1a9fb8", "#7a8b1f",
                                                "#8c5a3c", "#5563c1"};

// One channel of a colour given by hue (turns), saturation and lightness.
int channel(double hue, double saturation, double lightness, double shift) {
  const double k = std::fmod(shift + hue * 12, 12.0);
  const double swing = saturation * std::min(lightness, 1 - lightness);
  const double value = lightness - swing * std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0);
  return static_cast<int>(std::lround(value * 255));
}

}  // namespace

std::string robot_colour(std::size_t index) {
  if (index < kFirst.size()) return kFirst[index];
  constexpr double kGoldenRatio = 0.618033988749895;  // spreads hues evenly for any count
  const double hue = std::fmod(static_cast<double>(index) * kGoldenRatio, 1.0);
  const double lightness = 0.38 + 0.06 * static_cast<double>(index % 3);
  return fmt::format("#{:02x}{:02x}{:02x}", channel(hue, 0.62, lightness, 0),
                     channel(hue, 0.62, lightness, 8), channel(hue, 0.62, lightness, 4));
}

}  // namespace accord
