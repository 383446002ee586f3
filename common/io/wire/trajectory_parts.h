// Trajectories and configurations as parts of payloads. For the codecs' use.
#pragma once

#include "common/io/wire/inspector.h"
#include "common/model/robot.h"
#include "common/model/trajectory.h"

namespace accord::payload {
class Trajectory;
}

namespace accord {

// What any number of a configuration may be: within it a double still tells micrometres apart, and
// turns that have added up over a long path have room.
inline constexpr Range kConfigurationRange{-1e7, 1e7, ""};
inline constexpr Range kTimeRange{0, limits::kPlanTime, "s"};

void put_numbers(ConfigurationView values, WireDoubles& out);
// Requires: checked.
Configuration take_numbers(const WireDoubles& values);

void put_trajectory(const Trajectory& trajectory, payload::Trajectory& out);

// Waypoints of `dof` numbers at increasing times; or none, then of `dof` or 0.
bool take_trajectory(const payload::Trajectory& from, std::size_t dof, const PayloadPath& at,
                     Inspector& inspector, Trajectory& out);

}  // namespace accord
