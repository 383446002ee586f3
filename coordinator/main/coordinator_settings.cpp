#include "coordinator/main/coordinator_settings.h"

#include <algorithm>

#include "common/io/limits.h"
#include "common/transport/dds_settings.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/ros/ros_names.h"

namespace accord {
namespace {

using namespace std::chrono_literals;

constexpr unsigned kMostPlanning = 256;
constexpr const char* kAuto = "auto";
const std::string kNone = "none";
// Three heartbeats: less is given up where nothing is wrong.
constexpr auto kLeastLease = 300ms;
constexpr auto kLongestKept = 365 * 24h;

void add_storage_settings(Settings& table, CoordinatorSettings& settings) {
  table.add("journal", "--journal", settings.journal, path_or_none("a file", "FILE"),
            "Where accepted requests and finished plans survive a restart");
  table.add("keep", "--keep", settings.keep, rounded_seconds(0ms, kLongestKept),
            "How long finished plans are kept");
  table.add("scenes", "--scenes", settings.scenes, path_or_none("a folder", "FOLDER"),
            "Scenes that requests may name");
  Notation<std::string> folder = path_or_none("a folder", "FOLDER");
  folder.expected = "the path of a folder, none or auto";
  table.add("quarantine", "--quarantine", settings.quarantine, std::move(folder),
            "Where the inputs of quarantined tasks are written; auto: beside the journal");
}

void add_limit_settings(Settings& table, CoordinatorLimits& limits) {
  table.add("limits.queued", "--max-queued", limits.queued, whole_number<std::size_t>(1, 1'000'000),
            "Requests that wait");
  table
      .add("limits.planning", "--max-planning", limits.planning, whole_number(1U, kMostPlanning),
           "Requests planned at once")
      .initial = kOneForEachCore;
  table.add("limits.request_bytes", "--max-request-bytes", limits.request_bytes,
            bytes(std::size_t{1} << 10, limits::kSceneBytes + kAttachmentBytes),
            "Size of a request, scene and files together");
  table.add("limits.robots", "--max-robots", limits.robots,
            whole_number<std::size_t>(1, limits::kRobots), "Robots of a request");
  table.add("limits.waypoints", "--max-waypoints", limits.waypoints,
            whole_number<std::size_t>(1, 1'000'000'000), "Waypoints of a finished plan");
}

void add_worker_settings(Settings& table, CoordinatorSettings& settings) {
  table
      .add("threads", "--threads", settings.threads, whole_number(1U, 1024U),
           "Threads that prove plans")
      .initial = kOneForEachCore;
  table.add("lease", "--lease", settings.lease, rounded_seconds(kLeastLease, 1h),
            "Silence until a worker is given up");
  table.add("deaths", "--deaths", settings.deaths, whole_number(1U, 100U),
            "Workers lost with a task until it is quarantined");
}

void add_ros_settings(Settings& table, RosOptions& ros) {
  Notation<std::string> name =
      text("none, or names of letters, digits and '_' with '/' between them", "NAME",
           [](std::string_view value) { return value == kNone || is_ros_name(value); });
  const auto parse = name.parse;
  name.parse = [parse](std::string_view value) {
    auto parsed = parse(value);
    if (parsed == kNone) parsed->clear();
    return parsed;
  };
  name.print = [](const std::string& value) { return value.empty() ? kNone : value; };
  table.add("ros.name", "--ros", ros.name, std::move(name),
            "Publish paths for ROS 2, too, on topics below this name");
  table.add("ros.frame", "--ros-frame", ros.frame,
            text("a name without spaces", "NAME",
                 [](std::string_view value) { return is_ros_name(value); }),
            "The frame of these paths");
}

}  // namespace

CoordinatorLimits::CoordinatorLimits() : planning(std::min(cores(), kMostPlanning)) {}

std::string CoordinatorSettings::quarantine_folder() const {
  if (quarantine != kAuto) return quarantine;
  return journal.empty() ? "" : journal + ".quarantine";
}

Settings coordinator_table(CoordinatorSettings& settings) {
  Settings table;
  add_storage_settings(table, settings);
  add_worker_settings(table, settings);
  add_limit_settings(table, settings.limits);
  add_dds_settings(table, settings.dds);
  add_ros_settings(table, settings.ros);
  add_log_settings(table, settings.log);
  add_metrics_settings(table, settings.metrics);
  return table;
}

}  // namespace accord
