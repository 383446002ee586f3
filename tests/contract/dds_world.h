// DDS for tests: on 127.0.0.1 and shared memory only, in a domain and a cluster drawn at random, so
// that tests at the same time and other people's DDS know nothing of each other.
#pragma once

#include <random>
#include <stdexcept>
#include <string>

#include "common/transport/dds_bus.h"
#include "tests/contract/bus_contract.h"

namespace accord {

inline DdsOptions local_dds(DdsOptions::Transport transport) {
  std::random_device entropy;
  DdsOptions options;
  options.domain = 1 + entropy() % 200;
  options.cluster = "test-" + std::to_string(entropy());
  options.transport = transport;
  options.interfaces = {"127.0.0.1"};
  options.segment_bytes = std::size_t{16} << 20;  // making one of 64 MiB takes 150 ms
  options.announcement = std::chrono::milliseconds(50);
  return options;
}

inline void PrintTo(DdsOptions::Transport transport, std::ostream* out) {
  *out << (transport == DdsOptions::Transport::kUdp ? "UDP" : "shared memory");
}

class DdsWorld final : public bus_contract::World {
 public:
  explicit DdsWorld(DdsOptions options) : options_(std::move(options)) {}

  const DdsOptions& options() const { return options_; }

  std::unique_ptr<Bus> join(Role role, std::uint32_t protocol = kProtocol) override {
    options_.protocol = protocol;
    auto bus = make_dds_bus(role, options_);
    if (!bus) throw std::runtime_error(bus.error());
    return std::move(*bus);
  }

 private:
  DdsOptions options_;
};

}  // namespace accord
