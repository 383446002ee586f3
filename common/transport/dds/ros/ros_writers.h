// Publishes robots' paths on topics of ROS 2, one a robot, which keep the latest for who comes
// later.
#pragma once

#include <cstddef>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <map>
#include <string>

#include "common/model/plan.h"
#include "common/model/scene.h"
#include "common/transport/ros/ros_options.h"

namespace accord::dds {

// Not thread safe; not to be called by Fast DDS's threads.
class RosWriters {
 public:
  // So many topics at most; robots beyond them are published on the public topics only.
  static constexpr std::size_t kMost = 10'000;

  // The participant outlives this. Nothing is published where `options` names nothing.
  RosWriters(eprosima::fastdds::dds::DomainParticipant& participant, RosOptions options);
  ~RosWriters();
  RosWriters(const RosWriters&) = delete;
  RosWriters& operator=(const RosWriters&) = delete;

  // Requires: the plan is of that scene; of all its robots, or of none.
  void publish(const Plan& plan, const Scene& scene);

 private:
  // nullptr where there are too many, or Fast DDS refuses.
  template <typename Support>
  eprosima::fastdds::dds::DataWriter* writer_of(const std::string& topic);

  eprosima::fastdds::dds::DomainParticipant& participant_;
  RosOptions options_;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;              // made when first needed
  std::map<std::string, eprosima::fastdds::dds::DataWriter*> writers_;  // by topic
};

}  // namespace accord::dds
