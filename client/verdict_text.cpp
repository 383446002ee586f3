#include "client/verdict_text.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace accord {
namespace {

constexpr double kDecimals = 1e4;  // of a metre that are shown

// Rounded down: what is shown is a lower bound, too. A little is added so that 0.05 stays 0.05.
double shown(double distance) {
  return std::floor(distance * kDecimals + 1e-6) / kDecimals;
}

std::string separation_text(const std::optional<Separation>& separation, double clearance) {
  if (!separation) return "1 m or more";
  // "At least 0.0000 m" would look like contact, when it is the proof that there is none.
  const double distance = shown(separation->distance);
  const std::string bound = distance > clearance
                                ? fmt::format("at least {:.4f} m", distance)
                                : fmt::format("more than the clearance of {:g} m", clearance);
  return fmt::format("{}, {} and {} at t = {:.2f} s", bound, separation->first, separation->second,
                     separation->time);
}

}  // namespace

void add_separations(Table& table, const Scene& scene, const Verdict& verdict) {
  if (scene.robots.size() > 1)
    table.add("between robots", separation_text(verdict.robots, scene.clearance));
  if (!scene.obstacles.empty())
    table.add("to obstacles", separation_text(verdict.obstacles, scene.clearance));
}

}  // namespace accord
