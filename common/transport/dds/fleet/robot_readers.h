// Which robots somebody reads the paths of, each in its own partition, as discovery tells.
#pragma once

#include <fastdds/rtps/common/Guid.h>

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace accord::dds {

// Thread safe: Fast DDS's threads report, the one that sends plans asks.
class RobotReaders {
 public:
  using Guid = eprosima::fastrtps::rtps::GUID_t;
  using GuidPrefix = eprosima::fastrtps::rtps::GuidPrefix_t;

  explicit RobotReaders(std::string cluster) : cluster_(std::move(cluster)) {}

  // A reader of paths is there, in these partitions; or in others than before.
  void found(const Guid& reader, const std::vector<std::string>& partitions);
  void gone(const Guid& reader);
  // With all its readers.
  void gone(const GuidPrefix& participant);

  std::set<std::string> robots() const;

  // Called when there may be other robots than before, on whatever thread says so; not any more
  // when another one, or none, is set. It must not call this.
  void set_listener(std::function<void()> changed);

 private:
  const std::string cluster_;
  mutable std::mutex mutex_;
  std::map<Guid, std::set<std::string>> robots_;  // by reader
  std::function<void()> changed_;
};

}  // namespace accord::dds
