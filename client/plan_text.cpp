#include "client/plan_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "client/counted.h"
#include "client/table.h"
#include "client/verdict_text.h"
#include "common/io/words.h"

namespace accord {
namespace {

// 0 where the run did not count it.
double statistic(const Plan& plan, std::string_view name) {
  const auto found =
      std::ranges::find(plan.statistics, name, &std::pair<std::string, double>::first);
  return found == plan.statistics.end() ? 0 : found->second;
}

std::string costs_text(const Plan& plan) {
  std::string out =
      fmt::format("{:.2f} s ({} timesteps)", plan.sum_of_costs, plan.sum_of_costs_timesteps);
  const double bound = statistic(plan, "lower_bound");
  if (bound > 0) {
    out += fmt::format(", {:.1f} % above what the robots would need alone",
                       100 * (plan.sum_of_costs / bound - 1));
  }
  return out;
}

// One resolution can remove several conflicts, and a removed one can come back elsewhere: the
// counts are of different things and need not agree.
std::string conflicts_text(const Plan& plan) {
  const auto count = [&](std::string_view name) {
    return static_cast<std::uint64_t>(statistic(plan, name));
  };
  if (count("conflicts_found") == 0) return "none";
  return fmt::format("{} found, {} in {}", count("conflicts_found"),
                     counted(count("conflicts_resolved"), "resolution"),
                     counted(count("rounds"), "round"));
}

// "prioritized-query 31, decoupled-prm 2"; empty where there was nothing to solve.
std::string solvers_text(const Plan& plan) {
  constexpr std::string_view kPrefix = "solved_by_";
  std::string out;
  for (const auto& [name, count] : plan.statistics) {
    if (!name.starts_with(kPrefix) || count <= 0) continue;
    if (!out.empty()) out += ", ";
    out += fmt::format("{} {:.0f}", name.substr(kPrefix.size()), count);
  }
  return out;
}

}  // namespace

std::string solved_text(const Scene& scene, const Plan& plan, const Verdict& verdict) {
  Table table;
  table.add("status", "solved, and proved free of collisions at every instant");
  table.add("robots", std::to_string(plan.robots.size()));
  table.add("makespan", fmt::format("{:.2f} s", plan.makespan));
  table.add("sum of costs", costs_text(plan));
  table.add("conflicts", conflicts_text(plan));
  if (const std::string solvers = solvers_text(plan); !solvers.empty()) {
    table.add("solved by", solvers);
  }
  add_separations(table, scene, verdict);
  table.add("planned in", fmt::format("{:.3f} s", plan.planning_time));
  return table.str();
}

std::string unsolved_text(const Plan& plan) {
  constexpr std::size_t kMessage = 64U << 10U;  // bytes; it may come from a service
  return fmt::format("{}: {}\n", to_string(plan.status), printable(plan.message, kMessage));
}

}  // namespace accord
