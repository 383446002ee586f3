#include "common/transport/fleet/simulated_fleet_core.h"

#include <utility>

namespace accord {
namespace {

// How much of a kind of part is kept for who comes later.
std::size_t kept(const FleetPart& part) {
  if (std::holds_alternative<ServiceStatus>(part)) return 1;
  const bool of_one_question = std::holds_alternative<RequestReply>(part) ||
                               std::holds_alternative<PlanOutline>(part) ||
                               std::holds_alternative<PathPiece>(part);
  return of_one_question ? 0 : SimulatedFleetCore::kLatest;
}

}  // namespace

// ---- Who is there ----

std::shared_ptr<SimulatedFleetCore::Service> SimulatedFleetCore::serve(std::function<void()> wake) {
  const std::scoped_lock lock(mutex_);
  service_ = std::make_shared<Service>();
  service_->wake = std::move(wake);
  changed_.notify_all();
  return service_;
}

std::shared_ptr<SimulatedFleetCore::Client> SimulatedFleetCore::join() {
  const std::scoped_lock lock(mutex_);
  auto client = clients_.emplace_back(std::make_shared<Client>());
  if (!service_) return client;
  for (const auto& kind : service_->latest) {
    for (const SharedPart& part : kind) client->inbox.send(part, faults_, random_);
  }
  return client;
}

void SimulatedFleetCore::leave(const std::shared_ptr<Client>& client) {
  const std::scoped_lock lock(mutex_);
  std::erase(clients_, client);
}

void SimulatedFleetCore::leave(const std::shared_ptr<Service>& service) {
  const std::scoped_lock lock(mutex_);
  if (service_ == service) end_service();
}

void SimulatedFleetCore::kill_service() {
  const std::scoped_lock lock(mutex_);
  end_service();
}

void SimulatedFleetCore::end_service() {
  if (service_) service_->inbox = SimulatedInbox<FleetRequest>(kRequests);
  service_ = nullptr;
  changed_.notify_all();
}

bool SimulatedFleetCore::has_service() const {
  const std::scoped_lock lock(mutex_);
  return service_ != nullptr;
}

// ---- What is on its way ----

void SimulatedFleetCore::set_faults(const FleetFaults& faults) {
  const std::scoped_lock lock(mutex_);
  faults_ = faults;
}

bool SimulatedFleetCore::send(const FleetRequest& request) {
  const std::scoped_lock lock(mutex_);
  if (!service_ || service_->inbox.size() >= kRequests) return false;
  service_->inbox.send(request, faults_, random_);
  service_->wake();
  return true;
}

bool SimulatedFleetCore::publish(const std::shared_ptr<Service>& from, FleetPart part) {
  const std::scoped_lock lock(mutex_);
  if (service_ != from) return false;
  const auto shared = std::make_shared<const FleetPart>(std::move(part));
  auto& latest = service_->latest[shared->index()];
  latest.push_back(shared);
  if (latest.size() > kept(*shared)) latest.pop_front();
  for (const auto& client : clients_) client->inbox.send(shared, faults_, random_);
  changed_.notify_all();
  return true;
}

std::optional<FleetRequest> SimulatedFleetCore::take(Service& service) {
  const std::scoped_lock lock(mutex_);
  return service.inbox.take();
}

std::optional<FleetPart> SimulatedFleetCore::take(Client& client) {
  const std::scoped_lock lock(mutex_);
  const auto part = client.inbox.take();
  if (!part) return std::nullopt;
  return **part;
}

void SimulatedFleetCore::wait(Client& client, std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  const bool had_service = service_ != nullptr;
  changed_.wait_for(lock, timeout, [&] {
    return client.inbox.size() > 0 || (service_ != nullptr) != had_service;
  });
}

}  // namespace accord
