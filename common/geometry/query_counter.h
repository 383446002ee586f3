// Counts events from many threads without slowing any: each thread adds to a slot of its own.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace accord {

// A small number that no other living thread has, while there are few threads; kSlots - 1 and up
// are shared.
std::size_t thread_slot();

class QueryCounter {
 public:
  static constexpr std::size_t kSlots = 64;

  void add(std::uint64_t n) {
    const std::size_t slot = thread_slot();
    if (slot < kSlots - 1) {
      auto& count = counts_[slot].value;  // ours alone: no locked instruction needed
      count.store(count.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
    } else {
      counts_[kSlots - 1].value.fetch_add(n, std::memory_order_relaxed);
    }
  }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const Slot& slot : counts_) sum += slot.value.load(std::memory_order_relaxed);
    return sum;
  }

 private:
  struct alignas(64) Slot {
    std::atomic<std::uint64_t> value{0};
  };
  std::array<Slot, kSlots> counts_;
};

}  // namespace accord
