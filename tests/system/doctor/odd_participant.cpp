// A participant such as real processes cannot be made to be, until it is killed:
//
//   odd_participant protocol N IP CLUSTER     a worker of that protocol
//   odd_participant secured FOLDER IP CLUSTER says to be a worker, and wants a certificate; its own
//                                             is in the folder: ca.pem, cert.pem, key.pem
#include <unistd.h>

#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <iostream>
#include <string>

#include "common/transport/dds/peer_name.h"
#include "common/transport/dds/qos.h"
#include "common/transport/dds_bus.h"

namespace accord {
namespace {

int speak_another_protocol(const DdsOptions& options) {
  const auto bus = make_dds_bus(Role::kWorker, options);
  if (!bus) {
    std::cerr << bus.error() << '\n';
    return 1;
  }
  Announcement announcement;
  announcement.protocol = options.protocol;
  announcement.version = "9.9.9";
  for (;;) {
    (*bus)->publish(EndpointId{0}, announcement);
    (*bus)->wait_for_event(std::chrono::milliseconds(100));
    while ((*bus)->take()) {
    }
  }
}

int demand_certificates(const DdsOptions& options, const std::string& folder) {
  const dds::PeerName name{options.cluster, options.protocol, Role::kWorker, random_endpoint_id()};
  auto qos = dds::participant_qos(options, dds::to_user_data(name));
  auto& properties = qos.properties().properties();
  const std::string prefix = "dds.sec.auth.builtin.PKI-DH.";
  properties.emplace_back("dds.sec.auth.plugin", "builtin.PKI-DH");
  properties.emplace_back(prefix + "identity_ca", "file://" + folder + "/ca.pem");
  properties.emplace_back(prefix + "identity_certificate", "file://" + folder + "/cert.pem");
  properties.emplace_back(prefix + "private_key", "file://" + folder + "/key.pem");
  const auto* participant =
      eprosima::fastdds::dds::DomainParticipantFactory::get_instance()->create_participant(
          options.domain, qos);
  if (participant == nullptr) {
    std::cerr << "no participant with these certificates\n";
    return 1;
  }
  for (;;) pause();
}

}  // namespace
}  // namespace accord

int main(int argc, char** argv) {
  using namespace accord;
  if (argc != 5) {
    std::cerr << "usage: odd_participant protocol|secured N|FOLDER IP CLUSTER\n";
    return 2;
  }
  DdsOptions options;
  options.transport = DdsOptions::Transport::kUdp;
  options.interfaces = {argv[3]};
  options.cluster = argv[4];
  if (std::string(argv[1]) == "secured") return demand_certificates(options, argv[2]);
  options.protocol = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
  return speak_another_protocol(options);
}
