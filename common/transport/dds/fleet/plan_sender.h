// Sends plans, on a thread of its own: the pieces of a large one take longer than the service's
// loop may be held up, and must not come faster than those who listen can take them. Each robot
// that is read on its own gets its path, too, and when it comes later, its latest one.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "common/transport/dds/fleet/robot_readers.h"
#include "common/transport/dds/fleet/robot_writers.h"
#include "common/transport/dds/ros/ros_writers.h"
#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/latest_paths.h"

namespace accord::dds {

// send() from one thread. Destruction ends what is being sent.
class PlanSender {
 public:
  // Nobody else writes with these, which outlive it, as `robots` and `traffic` do.
  PlanSender(const std::string& cluster, const RosOptions& ros,
             eprosima::fastdds::dds::DataWriter& outlines,
             eprosima::fastdds::dds::DataWriter& paths, RobotReaders& robots,
             FleetTraffic& traffic);
  ~PlanSender();
  PlanSender(const PlanSender&) = delete;
  PlanSender& operator=(const PlanSender&) = delete;

  // After those before it. A plan whose turn has not come is sent once, however often it is asked
  // for. False: too much waits already, and it is dropped. Requires: fleet_fault() of it is
  // nullopt.
  bool send(FinishedPlan plan);

 private:
  struct Waiting {
    std::shared_ptr<const FinishedPlan> plan;  // without its scene, which nobody has to keep
    std::shared_ptr<const Scene> scene;
  };

  void run();
  void send_now(const FinishedPlan& plan);
  void let_them_catch_up();
  void robots_changed();
  void look_after_robots();

  eprosima::fastdds::dds::DataWriter& outlines_;
  eprosima::fastdds::dds::DataWriter& paths_;
  RobotReaders& robots_;
  FleetTraffic& traffic_;
  // The sending thread's:
  RobotWriters robot_writers_;
  RosWriters ros_;
  LatestPaths latest_;
  std::atomic<bool> ended_ = false;
  std::size_t ahead_ = 0;  // pieces since the last that all had got; the sending thread's
  std::mutex mutex_;
  std::condition_variable wake_;
  bool are_robots_changed_ = false;
  std::deque<Waiting> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::thread thread_;
};

}  // namespace accord::dds
