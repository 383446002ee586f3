#include "common/planning/random.h"

namespace accord {
namespace {

constexpr std::array<std::uint64_t, 12> kPrimes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};

double unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace

double halton(std::uint64_t index, std::size_t dimension, std::uint64_t seed) {
  const std::uint64_t stream = combine({seed, dimension});
  if (dimension >= kPrimes.size()) return unit(combine({stream, index}));
  const std::uint64_t base = kPrimes[dimension];
  double value = unit(stream);
  double digit = 1.0 / static_cast<double>(base);
  for (std::uint64_t i = index + 1; i > 0; i /= base) {
    value += static_cast<double>(i % base) * digit;
    digit /= static_cast<double>(base);
  }
  return value - static_cast<double>(static_cast<std::int64_t>(value));
}

}  // namespace accord
