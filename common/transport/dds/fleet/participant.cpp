#include "common/transport/dds/fleet/participant.h"

#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/qos/SubscriberQos.hpp>

namespace accord::dds {

tl::expected<std::unique_ptr<FleetParticipant>, std::string> FleetParticipant::create(
    const DdsOptions& options, const std::string& partition, const char* role,
    eprosima::fastdds::dds::DomainParticipantListener* listener, std::uint64_t* refused) {
  std::unique_ptr<FleetParticipant> out(new FleetParticipant(refused));
  const auto joined = join_domain(options, fleet_user_data(options.cluster, role), listener);
  if (!joined) return tl::unexpected(joined.error());
  out->participant_ = *joined;
  if (!out->join(partition)) return tl::unexpected(std::string("DDS refused a partition"));
  return out;
}

bool FleetParticipant::join(const std::string& partition) {
  eprosima::fastdds::dds::PublisherQos publisher;
  publisher.partition().push_back(partition.c_str());
  publisher_ = participant_->create_publisher(publisher);
  eprosima::fastdds::dds::SubscriberQos subscriber;
  subscriber.partition().push_back(partition.c_str());
  subscriber_ = participant_->create_subscriber(subscriber);
  return publisher_ != nullptr && subscriber_ != nullptr;
}

}  // namespace accord::dds
