#include "common/geometry/query_counter.h"

#include <mutex>

namespace accord {

namespace internal {
constinit thread_local std::uint64_t thread_count = 0;
}

namespace {

// Hands out the lowest free numbers; threads give theirs back when they end.
class Slots {
 public:
  std::size_t take() {
    const std::lock_guard lock(mutex_);
    std::size_t slot = 0;
    while (slot < QueryCounter::kSlots - 1 && taken_[slot]) ++slot;
    if (slot < QueryCounter::kSlots - 1) taken_[slot] = true;
    return slot;
  }
  void give_back(std::size_t slot) {
    const std::lock_guard lock(mutex_);
    if (slot < QueryCounter::kSlots - 1) taken_[slot] = false;
  }

 private:
  std::mutex mutex_;
  std::array<bool, QueryCounter::kSlots> taken_{};
};

Slots& slots() {
  static Slots* const slots = new Slots;  // outlives every thread
  return *slots;
}

struct Lease {
  std::size_t slot = slots().take();
  ~Lease() { slots().give_back(slot); }
};

constinit thread_local std::size_t cached_slot = SIZE_MAX;

}  // namespace

std::size_t thread_slot() {
  if (cached_slot == SIZE_MAX) {
    thread_local const Lease lease;
    cached_slot = lease.slot;
  }
  return cached_slot;
}

}  // namespace accord
