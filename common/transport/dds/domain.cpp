#include "common/transport/dds/domain.h"

#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include "common/transport/dds/qos.h"

namespace accord::dds {
namespace {

using namespace eprosima::fastdds::dds;

// Fast DDS hands messages within one process from thread to thread; two endpoints in one process,
// as tests have, then never see what the transport does. One for all participants of the process.
void use_transports_within_the_process() {
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

}  // namespace

tl::expected<DomainParticipant*, std::string> join_domain(const DdsOptions& options,
                                                          const std::string& user_data,
                                                          DomainParticipantListener* listener) {
  use_transports_within_the_process();
  DomainParticipant* participant = DomainParticipantFactory::get_instance()->create_participant(
      options.domain, participant_qos(options, user_data), listener, StatusMask::none());
  if (participant != nullptr) return participant;
  return tl::unexpected("DDS could not join domain " + std::to_string(options.domain) +
                        "; are the interfaces this machine's, and is there room in /dev/shm?");
}

void leave_domain(DomainParticipant& participant) {
  participant.set_listener(nullptr);
  participant.delete_contained_entities();
  DomainParticipantFactory::get_instance()->delete_participant(&participant);
}

Topic* add_topic(DomainParticipant& participant, const std::string& name, const TypeSupport& type) {
  // Cyclone DDS drops endpoints whose types Fast DDS describes.
  type->auto_fill_type_information(false);
  type->auto_fill_type_object(false);
  if (participant.register_type(type) != ReturnCode_t::RETCODE_OK) return nullptr;
  return participant.create_topic(name, type.get_type_name(), TOPIC_QOS_DEFAULT);
}

}  // namespace accord::dds
