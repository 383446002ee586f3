#include "common/transport/dds/fleet/robot_readers.h"

#include "common/transport/fleet/robot_partition.h"

namespace accord::dds {

void RobotReaders::found(const Guid& reader, const std::vector<std::string>& partitions) {
  std::set<std::string> wanted;
  for (const std::string& partition : partitions) {
    if (auto robot = robot_of_partition(cluster_, partition)) wanted.insert(std::move(*robot));
  }
  const std::scoped_lock lock(mutex_);
  if (wanted.empty() && !robots_.contains(reader)) return;  // of all robots' paths
  robots_[reader] = std::move(wanted);
  if (changed_) changed_();
}

void RobotReaders::gone(const Guid& reader) {
  const std::scoped_lock lock(mutex_);
  if (robots_.erase(reader) > 0 && changed_) changed_();
}

void RobotReaders::gone(const GuidPrefix& participant) {
  const std::scoped_lock lock(mutex_);
  const auto erased = std::erase_if(
      robots_, [&](const auto& entry) { return entry.first.guidPrefix == participant; });
  if (erased > 0 && changed_) changed_();
}

void RobotReaders::set_listener(std::function<void()> changed) {
  const std::scoped_lock lock(mutex_);
  changed_ = std::move(changed);
}

std::set<std::string> RobotReaders::robots() const {
  const std::scoped_lock lock(mutex_);
  std::set<std::string> out;
  for (const auto& [reader, robots] : robots_) out.insert(robots.begin(), robots.end());
  return out;
}

}  // namespace accord::dds
