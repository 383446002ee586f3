// Writers of single robots' paths, one for each robot that somebody reads in its own partition: DDS
// sends such a reader that robot's path and nothing else, whoever has made the reader.
#pragma once

#include <cstddef>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/transport/fleet/fleet_traffic.h"
#include "common/transport/fleet/plan_parts.h"

namespace accord::dds {

// Not thread safe; not to be called by Fast DDS's threads.
class RobotWriters {
 public:
  // So many robots at most are written to; others hear of their paths with everybody else.
  static constexpr std::size_t kMost = 4096;

  // Their topic is that of `paths`, which writes to who reads all robots'. Both outlive this.
  RobotWriters(const std::string& cluster, eprosima::fastdds::dds::DataWriter& paths,
               FleetTraffic& traffic);
  ~RobotWriters();
  RobotWriters(const RobotWriters&) = delete;
  RobotWriters& operator=(const RobotWriters&) = delete;

  // Has writers for these robots, and no others. Returns those that had none before.
  std::vector<std::string> keep(const std::set<std::string>& robots);
  // Nothing happens where nobody reads the robot's paths.
  void write(const PathPiece& piece);

 private:
  struct Writer {
    eprosima::fastdds::dds::Publisher* publisher = nullptr;
    eprosima::fastdds::dds::DataWriter* writer = nullptr;
    std::size_t ahead = 0;  // pieces since the last that all had got
  };

  bool add(const std::string& robot);
  void remove(const Writer& writer);

  std::string cluster_;
  eprosima::fastdds::dds::DataWriter& paths_;
  FleetTraffic& traffic_;
  eprosima::fastdds::dds::DomainParticipant& participant_;
  std::map<std::string, Writer> writers_;  // by robot
};

}  // namespace accord::dds
