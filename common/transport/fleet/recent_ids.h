// The latest few of many ids, each with a number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace accord {

// Not thread safe.
class RecentIds {
 public:
  explicit RecentIds(std::size_t most) : most_(most) {}

  // As the latest; the one that has been here for longest goes where there are too many.
  void add(const std::string& id, std::uint32_t number) {
    erase(id);
    order_.emplace_back(id, number);
    places_.emplace(id, std::prev(order_.end()));
    if (order_.size() > most_) erase(std::string(order_.front().first));
  }
  void erase(const std::string& id) {
    const auto place = places_.find(id);
    if (place == places_.end()) return;
    order_.erase(place->second);
    places_.erase(place);
  }
  std::optional<std::uint32_t> find(const std::string& id) const {
    const auto place = places_.find(id);
    if (place == places_.end()) return std::nullopt;
    return place->second->second;
  }

 private:
  using Order = std::list<std::pair<std::string, std::uint32_t>>;  // the latest last

  std::size_t most_;
  Order order_;
  std::unordered_map<std::string, Order::iterator> places_;
};

}  // namespace accord
