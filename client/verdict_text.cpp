#include "client/verdict_text.h"

#include <fmt/format.h>

#include <optional>

namespace accord {
namespace {

std::string separation_text(const std::optional<Separation>& separation) {
  if (!separation) return "1 m or more";
  // Four decimals, or the order of magnitude of less than that.
  const double distance = separation->distance;
  const std::string metres =
      distance >= 1e-4 ? fmt::format("{:.4f}", distance) : fmt::format("{:.1g}", distance);
  return fmt::format("at least {} m, {} and {} at t = {:.2f} s", metres, separation->first,
                     separation->second, separation->time);
}

}  // namespace

void add_separations(Table& table, const Scene& scene, const Verdict& verdict) {
  if (scene.robots.size() > 1) table.add("between robots", separation_text(verdict.robots));
  if (!scene.obstacles.empty()) table.add("to obstacles", separation_text(verdict.obstacles));
}

}  // namespace accord
