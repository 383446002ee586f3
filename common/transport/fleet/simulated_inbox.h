// What is on its way to one end of the simulated public topics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "common/planning/random.h"
#include "common/transport/fleet/simulated_fleet.h"

namespace accord {

// Not thread safe.
template <typename Item>
class SimulatedInbox {
 public:
  explicit SimulatedInbox(std::size_t most) : most_(most) {}

  void send(const Item& item, const FleetFaults& faults, RandomStream& random) {
    // All are drawn whatever happens, so that one fault more does not change the rest of a run.
    const bool dropped = random.uniform() < faults.drop;
    const bool twice = random.uniform() < faults.duplicate;
    const bool straggles = random.uniform() < faults.reorder;
    const std::size_t late = 1 + random.below(kStraggling);
    const std::size_t again = 1 + random.below(kStraggling);
    ++sent_;
    if (!dropped) straggles ? void(stragglers_.emplace(sent_ + late, item)) : arrive(item);
    if (twice) stragglers_.emplace(sent_ + again, item);
    while (!stragglers_.empty() && stragglers_.begin()->first <= sent_) admit_straggler();
  }

  // Nobody waits for what would overtake a straggler and is not sent.
  std::optional<Item> take() {
    if (items_.empty() && !stragglers_.empty()) admit_straggler();
    if (items_.empty()) return std::nullopt;
    Item out = std::move(items_.front());
    items_.pop_front();
    return out;
  }
  std::size_t size() const { return items_.size() + stragglers_.size(); }

 private:
  static constexpr std::size_t kStraggling = 20;

  void arrive(Item item) {
    items_.push_back(std::move(item));
    if (items_.size() > most_) items_.pop_front();
  }
  void admit_straggler() {
    auto first = stragglers_.extract(stragglers_.begin());
    arrive(std::move(first.mapped()));
  }

  std::size_t most_;
  std::uint64_t sent_ = 0;
  std::deque<Item> items_;
  std::multimap<std::uint64_t, Item> stragglers_;  // by what has to be sent before they come
};

}  // namespace accord
