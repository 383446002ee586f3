// Who is there, and what is on its way between them: what the ports of a SimulatedFleet share.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "common/planning/random.h"
#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/plan_parts.h"
#include "common/transport/fleet/simulated_inbox.h"

namespace accord {

// Thread safe.
class SimulatedFleetCore {
 public:
  using SharedPart = std::shared_ptr<const FleetPart>;  // one for all clients
  static constexpr std::size_t kRequests = 4096;  // that wait for the service: no more can be sent
  static constexpr std::size_t kParts = 65'536;   // that wait for a client
  static constexpr std::size_t kLatest = 1024;    // of a kind, for who comes later

  struct Client {
    SimulatedInbox<SharedPart> inbox{kParts};
  };
  // One life of the service.
  struct Service {
    std::function<void()> wake;
    SimulatedInbox<FleetRequest> inbox{kRequests};
    std::array<std::deque<SharedPart>, std::variant_size_v<FleetPart>> latest;
  };

  explicit SimulatedFleetCore(std::uint64_t seed) : random_(seed) {}

  std::shared_ptr<Service> serve(std::function<void()> wake);
  std::shared_ptr<Client> join();
  void leave(const std::shared_ptr<Client>& client);
  void leave(const std::shared_ptr<Service>& service);  // perhaps of a life that is over
  void kill_service();
  void set_faults(const FleetFaults& faults);

  bool has_service() const;
  bool send(const FleetRequest& request);
  bool publish(const std::shared_ptr<Service>& from, FleetPart part);
  std::optional<FleetRequest> take(Service& service);
  std::optional<FleetPart> take(Client& client);
  void wait(Client& client, std::chrono::nanoseconds timeout);

 private:
  void end_service();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  RandomStream random_;
  FleetFaults faults_;
  std::shared_ptr<Service> service_;  // null: none is there
  std::vector<std::shared_ptr<Client>> clients_;
};

}  // namespace accord
