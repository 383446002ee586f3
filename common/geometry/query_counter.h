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

namespace internal {
extern constinit thread_local std::uint64_t thread_count;
}

// What its thread counts, on whatever counter, from when it is made: what a piece of work costs.
// Who has begun to count before does not count it, too: an attempt's cost is not its caller's, and
// what is worked out once for all who may come to need it is no attempt's.
// Not thread safe; ends on the thread that made it, in the reverse order of making.
class SeparateCost {
 public:
  SeparateCost() : before_(internal::thread_count) {}
  ~SeparateCost() { internal::thread_count = before_; }
  SeparateCost(const SeparateCost&) = delete;
  SeparateCost& operator=(const SeparateCost&) = delete;

  std::uint64_t so_far() const { return internal::thread_count - before_; }

 private:
  std::uint64_t before_;
};

class QueryCounter {
 public:
  static constexpr std::size_t kSlots = 64;

  void add(std::uint64_t n) {
    internal::thread_count += n;
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
