// Plan files (docs/formats.md): plans to JSON and back.
//
// Thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/model/plan.h"

namespace accord {

// The plan as JSON, a waypoint a line; the same bytes for the same plan. Numbers are the shortest
// that read back as the same doubles. Requires: all numbers finite (others are written as null,
// which no reader accepts).
std::string to_json(const Plan& plan);

// As to_json(), without what differs from run to run: planning_time, and statistics whose names end
// in "_time". Two runs of one request agree in these bytes.
std::string canonical_bytes(const Plan& plan);

struct PlanResult {
  std::optional<Plan> plan;        // nullopt where there is a fault
  std::vector<Diagnostic> faults;  // by line
};

// Reads any plan that follows the format, ours or somebody else's, and reports every fault of form:
// unknown, missing and repeated keys, wrong types, numbers that are not finite, times that do not
// increase, robots whose waypoints differ in size. Whether the plan is any good is for verify() to
// say. Statistics that are no numbers are passed over.
PlanResult load_plan(const std::filesystem::path& path);
PlanResult parse_plan(std::string_view text, const std::string& file);

}  // namespace accord
