// What is looked at of this machine, without DDS. Nothing here changes anything, and whatever
// cannot be looked at is left as it is by default.
// Thread safety: none of it is to be called from two threads at once.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "client/doctor/observations.h"

namespace accord {

// A look at /dev/shm. Takes the lock of each file for an instant, as Fast DDS itself does to find
// out whether an owner lives.
SharedMemory look_at_shared_memory();

// Where participants of this machine say to listen.
SharedPort look_at_shared_port(std::uint32_t port);

SocketBuffers look_at_socket_buffers();

// With a datagram through each interface that is up, to the domain's group and back, on a port that
// nobody listens on: takes up to a second.
std::vector<Interface> look_at_interfaces();

// Domains whose multicast port somebody here has open.
std::set<std::uint32_t> look_at_domains();

// Sends to addresses, at once, an empty message of DDS's protocol; what comes of it comes later.
class AddressProbes {
 public:
  // Where an address has no port: to those of the domain's first participants there.
  AddressProbes(const std::vector<DdsAddress>& addresses, const DdsOptions& options);
  ~AddressProbes();
  AddressProbes(const AddressProbes&) = delete;
  AddressProbes& operator=(const AddressProbes&) = delete;

  // What has come until now, in the order of the addresses.
  std::vector<AddressProbe> outcomes();

 private:
  struct Sent {
    std::size_t address;
    int socket;
  };
  void send_to(std::size_t place, std::uint16_t port);

  std::vector<AddressProbe> probes_;
  std::vector<Sent> sent_;
};

}  // namespace accord
