// Seeded random streams and low-discrepancy points. Nothing in Accord draws from a global or from
// the clock: a stream is named by its seed, and the same seed gives the same numbers on every
// machine (Blackman and Vigna's xoshiro256++; std distributions are not portable).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace accord {

// One step of splitmix64: spreads a seed over all bits.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// A seed made of several numbers, order mattering.
constexpr std::uint64_t combine(std::initializer_list<std::uint64_t> parts) {
  std::uint64_t seed = 0x243f6a8885a308d3ULL;
  for (const std::uint64_t part : parts) seed = mix(seed ^ mix(part));
  return seed;
}

class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) {
    for (std::uint64_t& word : state_) word = seed = mix(seed);
  }

  std::uint64_t next() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  // Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Uniform in [0, n). Requires: n > 0. The bias of the remainder is below 2^-32 for n < 2^32.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }

 private:
  std::array<std::uint64_t, 4> state_;
};

// Coordinate `dimension` (from 0) of point `index` of the Halton sequence, in [0, 1), with a
// rotation (Cranley-Patterson) that makes sequences of different seeds differ. Dimensions past the
// table of primes fall back to a hash of the index, which is as good there.
double halton(std::uint64_t index, std::size_t dimension, std::uint64_t seed);

}  // namespace accord
