// Sends plans, on a thread of its own: the pieces of a large one take longer than the service's
// loop may be held up, and must not come faster than those who listen can take them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <mutex>
#include <thread>

#include "common/transport/fleet/fleet_messages.h"

namespace accord::dds {

// send() from one thread. Destruction ends what is being sent.
class PlanSender {
 public:
  // Nobody else writes with these, which outlive it.
  PlanSender(eprosima::fastdds::dds::DataWriter& outlines,
             eprosima::fastdds::dds::DataWriter& paths);
  ~PlanSender();
  PlanSender(const PlanSender&) = delete;
  PlanSender& operator=(const PlanSender&) = delete;

  // After those before it. A plan whose turn has not come is sent once, however often it is asked
  // for. False: too much waits already, and it is dropped. Requires: fleet_fault() of it is
  // nullopt.
  bool send(FinishedPlan plan);

 private:
  void run();
  void send_now(const FinishedPlan& plan);
  void let_them_catch_up();

  eprosima::fastdds::dds::DataWriter& outlines_;
  eprosima::fastdds::dds::DataWriter& paths_;
  std::atomic<bool> ended_ = false;
  std::size_t ahead_ = 0;  // pieces since the last that all had got; the sending thread's
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<FinishedPlan> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::thread thread_;
};

}  // namespace accord::dds
