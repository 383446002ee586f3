// What discovery and samples said of each participant, for a survey.
#pragma once

#include <fastdds/rtps/builtin/data/ParticipantProxyData.h>
#include <fastdds/rtps/common/Guid.h>

#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "common/transport/dds/signal.h"
#include "common/transport/survey/domain_survey.h"

namespace accord::dds {

// What surveys call themselves: they do not count each other.
inline constexpr const char* kDoctorRole = "doctor";

// Thread safe: Fast DDS's threads report, the loop asks.
class SurveyBook {
 public:
  using Guid = eprosima::fastrtps::rtps::GUID_t;
  using GuidPrefix = eprosima::fastrtps::rtps::GuidPrefix_t;

  // `servers` are those that were asked for, in order.
  SurveyBook(std::vector<GuidPrefix> servers, Signal& signal)
      : servers_(std::move(servers)), signal_(signal) {}

  void set_own(const GuidPrefix& own);
  void discovered(const eprosima::fastrtps::rtps::ParticipantProxyData& data);
  void gone(const GuidPrefix& participant);
  void has_endpoint(const Guid& endpoint, const std::string& topic,
                    const eprosima::fastdds::dds::PartitionQosPolicy& partitions);
  void matched(const Guid& theirs, int change);
  // How old a sample may be: kKept, the first of a writer that gives its latest to whoever comes;
  // kLive, sent just now; kOld, of whenever.
  enum class Age { kLive, kKept, kOld };
  void heard(const eprosima::fastdds::dds::SampleInfo& info, Age age);

  std::vector<SeenParticipant> participants() const;

 private:
  // Null for own participants and where there are too many. Under the lock.
  SeenParticipant* entry(const GuidPrefix& participant);

  const std::vector<GuidPrefix> servers_;
  Signal& signal_;
  mutable std::mutex mutex_;
  std::map<GuidPrefix, SeenParticipant> entries_;
  std::set<Guid> endpoints_;
  std::set<Guid> heard_;  // writers that may have kept a sample, and have given one
  std::optional<GuidPrefix> own_;
};

}  // namespace accord::dds
