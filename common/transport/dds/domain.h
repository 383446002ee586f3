// Joining and leaving a DDS domain, and topics there: what the bus and the public topics share.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <string>
#include <tl/expected.hpp>

#include "common/transport/dds_options.h"

namespace accord::dds {

// A participant, or a sentence that says why there is none. `listener` may be null; it hears of
// participants only, and outlives the participant. Requires: sound options.
tl::expected<eprosima::fastdds::dds::DomainParticipant*, std::string> join_domain(
    const DdsOptions& options, const std::string& user_data,
    eprosima::fastdds::dds::DomainParticipantListener* listener);

// Deletes it and all that it has. No listener is called any more when this returns.
void leave_domain(eprosima::fastdds::dds::DomainParticipant& participant);

// Null where Fast DDS refuses.
eprosima::fastdds::dds::Topic* add_topic(eprosima::fastdds::dds::DomainParticipant& participant,
                                         const std::string& name,
                                         const eprosima::fastdds::dds::TypeSupport& type);

// Whose writer it is.
inline eprosima::fastdds::dds::DomainParticipant& participant_of(
    const eprosima::fastdds::dds::DataWriter& writer) {
  // Fast DDS gives it as constant, but by name.
  return const_cast<eprosima::fastdds::dds::DomainParticipant&>(
      *writer.get_publisher()->get_participant());
}

}  // namespace accord::dds
