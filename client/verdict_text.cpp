#include "client/verdict_text.h"

#include <fmt/format.h>

#include <optional>

namespace accord {
namespace {

std::string separation_text(const std::optional<Separation>& separation) {
  if (!separation) return "1 m or more";
  return fmt::format("at least {:.4f} m, {} and {} at t = {:.2f} s", separation->distance,
                     separation->first, separation->second, separation->time);
}

}  // namespace

void add_separations(Table& table, const Verdict& verdict) {
  table.add("between robots", separation_text(verdict.robots));
  table.add("to obstacles", separation_text(verdict.obstacles));
}

}  // namespace accord
