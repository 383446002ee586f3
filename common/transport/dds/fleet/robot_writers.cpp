#include "common/transport/dds/fleet/robot_writers.h"

#include <spdlog/spdlog.h>

#include <fastdds/dds/publisher/qos/PublisherQos.hpp>

#include "common/transport/dds/fleet/patient_write.h"
#include "common/transport/dds/fleet/topics.h"
#include "common/transport/dds/qos.h"
#include "common/transport/fleet/robot_partition.h"

namespace accord::dds {

RobotWriters::RobotWriters(const std::string& cluster, eprosima::fastdds::dds::DataWriter& paths,
                           FleetTraffic& traffic)
    : cluster_(cluster), paths_(paths), traffic_(traffic), participant_(participant_of(paths)) {}

RobotWriters::~RobotWriters() {
  for (const auto& [robot, writer] : writers_) remove(writer);
}

std::vector<std::string> RobotWriters::keep(const std::set<std::string>& robots) {
  std::erase_if(writers_, [&](const auto& entry) {
    if (robots.contains(entry.first)) return false;
    remove(entry.second);
    return true;
  });
  std::vector<std::string> added;
  for (const std::string& robot : robots) {
    if (writers_.contains(robot)) continue;
    if (writers_.size() >= kMost || !add(robot)) {
      spdlog::warn("topics: no writer for robot {}: there are {} already", robot, writers_.size());
      break;
    }
    added.push_back(robot);
  }
  return added;
}

bool RobotWriters::add(const std::string& robot) {
  eprosima::fastdds::dds::PublisherQos qos;
  qos.partition().push_back(robot_partition(cluster_, robot).c_str());
  Writer out;
  out.publisher = participant_.create_publisher(qos);
  if (out.publisher == nullptr) return false;
  out.writer = out.publisher->create_datawriter(paths_.get_topic(),
                                                latest_writer_qos(kRobotPathDepth), nullptr);
  if (out.writer == nullptr) {
    participant_.delete_publisher(out.publisher);
    return false;
  }
  writers_.emplace(robot, out);
  return true;
}

void RobotWriters::remove(const Writer& writer) {
  writer.publisher->delete_datawriter(writer.writer);
  participant_.delete_publisher(writer.publisher);
}

void RobotWriters::write(const PathPiece& piece) {
  const auto found = writers_.find(piece.robot);
  if (found == writers_.end()) return;
  write_patiently(piece, *found->second.writer, traffic_);
  if (++found->second.ahead < kRobotPathDepth / 2) return;
  found->second.writer->wait_for_acknowledgments(kPatience);
  found->second.ahead = 0;
}

}  // namespace accord::dds
