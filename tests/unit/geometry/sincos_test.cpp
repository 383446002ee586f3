#include "common/geometry/sincos.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace accord {
namespace {

void expect_close(double x) {
  const SinCos value = sincos(x);
  EXPECT_NEAR(value.sin, static_cast<double>(std::sin(static_cast<long double>(x))), 1e-15) << x;
  EXPECT_NEAR(value.cos, static_cast<double>(std::cos(static_cast<long double>(x))), 1e-15) << x;
  EXPECT_NEAR(value.sin * value.sin + value.cos * value.cos, 1, 4e-16) << x;
}

TEST(SinCos, IsWithin1e15OfTheTruth) {
  std::mt19937_64 random(1);
  for (const double span : {1e-3, 1.0, 10.0, 1e3, 9.9e4}) {
    std::uniform_real_distribution<double> angle(-span, span);
    for (int i = 0; i < 20000; ++i) expect_close(angle(random));
  }
}

TEST(SinCos, IsAccurateNextToMultiplesOfHalfPi) {
  for (int k = -60000; k <= 60000; k += 7) {
    const double x = k * (std::numbers::pi / 2);
    for (const double y : {x, std::nextafter(x, -1e9), std::nextafter(x, 1e9), x + 1e-9}) {
      expect_close(y);
    }
  }
}

TEST(SinCos, IsExactWhereItMatters) {
  EXPECT_EQ(sincos(0).sin, 0);
  EXPECT_EQ(sincos(0).cos, 1);
  EXPECT_EQ(sincos(-0.7).sin, -sincos(0.7).sin);
  EXPECT_EQ(sincos(-0.7).cos, sincos(0.7).cos);
}

TEST(SinCos, HandsHugeAndBrokenAnglesToTheLibrary) {
  EXPECT_EQ(sincos(3e7).sin, std::sin(3e7));
  EXPECT_TRUE(std::isnan(sincos(std::numeric_limits<double>::quiet_NaN()).sin));
  EXPECT_TRUE(std::isnan(sincos(std::numeric_limits<double>::infinity()).cos));
}

// The bits themselves, taken from one machine: another one that differs would plan differently.
TEST(SinCos, IsTheSameBitsOnEveryMachine) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (int i = 0; i < 100000; ++i) {
    const SinCos value = sincos(-50 + i * 0.00100001);
    for (const double v : {value.sin, value.cos}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(v)) * 1099511628211ULL;
    }
  }
  EXPECT_EQ(hash, 5234173660559988124ULL);
}

}  // namespace
}  // namespace accord
