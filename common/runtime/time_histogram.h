// How long things of one kind have taken, sorted into buckets: what a state machine counts for
// whoever watches over its process. A plain value, of the same buckets everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace accord {

struct TimeHistogram {
  // s: upper bounds, which belong to their buckets. From what telling a worker takes to what
  // nobody waits for.
  static constexpr std::array<double, 24> kBounds{1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02,
                                                  0.05, 0.1,  0.2,  0.5,  1,    2,    5,    10,
                                                  20,   50,   100,  200,  500,  1000, 2000, 5000};

  std::array<std::uint64_t, kBounds.size() + 1> counts{};  // the last bucket: beyond all bounds
  double sum = 0;                                          // s

  // Less than nothing, as a clock that was set back has it, is nothing.
  void add(double seconds) {
    const double time = seconds > 0 ? seconds : 0;
    const auto bucket = std::ranges::lower_bound(kBounds, time) - kBounds.begin();
    ++counts[static_cast<std::size_t>(bucket)];
    sum += time;
  }
  std::uint64_t total() const {
    std::uint64_t total = 0;
    for (const std::uint64_t count : counts) total += count;
    return total;
  }
};

}  // namespace accord
