// One robot's end of the public topics: hears of its own path and of nothing else, however many
// robots are planned. docs/topics.md tells how; any implementation of DDS can do the same.
// Not thread safe. Hostile peers: whatever arrives is within the limits of fleet_limits.h; what is
// not is dropped.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "common/transport/dds_options.h"
#include "common/transport/fleet/path_assembly.h"

namespace accord {

class RobotPort {
 public:
  virtual ~RobotPort() = default;

  // The next path that has come whole: the robot's latest one, where it comes later, then those of
  // each request that it is part of. A path that is sent again, since somebody asked for it, comes
  // again.
  virtual std::optional<RobotPath> take() = 0;
  // Waits until take() may give something. May return early.
  virtual void wait(std::chrono::nanoseconds timeout) = 0;
};

// Or a sentence that says why not: an option, or a name that has no partition (robot_partition.h).
tl::expected<std::unique_ptr<RobotPort>, std::string> make_dds_robot_port(const DdsOptions& options,
                                                                          const std::string& robot);

}  // namespace accord
