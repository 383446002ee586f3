// Every QoS that is used, in one place. The reasons are in docs/architecture.md; the figures behind
// them were measured on Debian 12 with Fast DDS 2.9.1.
#pragma once

#include <cstddef>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <string>

#include "common/transport/dds_discovery.h"
#include "common/transport/dds_options.h"

namespace accord::dds {

// Transports, discovery, leases. `user_data`: who the participant is (peer_name.h).
eprosima::fastdds::dds::DomainParticipantQos participant_qos(const DdsOptions& options,
                                                             const std::string& user_data);
// Of a discovery server.
eprosima::fastdds::dds::DomainParticipantQos server_qos(const DiscoveryServerOptions& options);

// Reliable, in order, nothing thrown away: a writer that has `depth` samples that a reader has not
// acknowledged refuses more.
eprosima::fastdds::dds::DataWriterQos writer_qos(std::size_t depth);
eprosima::fastdds::dds::DataReaderQos reader_qos(std::size_t depth);

// Reliable, in order, the latest: a writer that has `depth` samples forgets the oldest, whoever has
// not got it yet, and so does a reader. So nobody who is slow holds anybody up.
eprosima::fastdds::dds::DataWriterQos latest_writer_qos(std::size_t depth);
// `late`: the writers' latest from before it was there come, too.
eprosima::fastdds::dds::DataReaderQos latest_reader_qos(std::size_t depth, bool late);

}  // namespace accord::dds
