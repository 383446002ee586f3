// What values of settings look like, and what is none.
#include "common/runtime/notation.h"

#include <gtest/gtest.h>

#include <array>

namespace accord {
namespace {

using namespace std::chrono_literals;

TEST(WholeNumber, IsDecimalDigitsWithinItsRange) {
  const auto notation = whole_number(1U, 1024U);
  EXPECT_EQ(notation.expected, "a whole number from 1 to 1024");
  EXPECT_EQ(notation.parse("1"), 1U);
  EXPECT_EQ(notation.parse("1024"), 1024U);
  for (const char* wrong :
       {"", "0", "1025", "-1", "+1", "1.0", "0x10", " 1", "1 ", "one", "18446744073709551617"}) {
    EXPECT_EQ(notation.parse(wrong), std::nullopt) << wrong;
  }
  EXPECT_EQ(notation.print(7), "7");
}

TEST(Seconds, AreNumbersWithinTheirRange) {
  const auto notation = seconds(0.5, 31'536'000);
  EXPECT_EQ(notation.expected, "a number from 0.5 to 31536000 s");
  EXPECT_EQ(notation.parse("0.5"), 0.5);
  EXPECT_EQ(notation.parse("1e3"), 1000);
  for (const char* wrong : {"", "0.4", "31536001", ".inf", ".nan", "nan", "-1", "1 s"}) {
    EXPECT_EQ(notation.parse(wrong), std::nullopt) << wrong;
  }
}

TEST(RoundedSeconds, ArePrintedAsTheyWereWritten) {
  const auto notation = rounded_seconds(2ms, 1h);
  EXPECT_EQ(notation.parse("0.2"), 200ms);
  EXPECT_EQ(notation.parse("0.0024"), 2ms);
  EXPECT_EQ(notation.parse("0.001"), std::nullopt);
  EXPECT_EQ(notation.print(200ms), "0.2");
  EXPECT_EQ(notation.print(1h), "3600");
}

TEST(Bytes, MayHaveAUnit) {
  const auto notation = bytes(1, std::size_t{1} << 30);
  EXPECT_EQ(notation.expected, "a size from 1 to 1 GiB");
  EXPECT_EQ(notation.parse("1000"), 1000U);
  EXPECT_EQ(notation.parse("16 MiB"), std::size_t{16} << 20);
  EXPECT_EQ(notation.parse("16MiB"), std::size_t{16} << 20);
  EXPECT_EQ(notation.parse("1 GiB"), std::size_t{1} << 30);
  for (const char* wrong : {"", "0", "2 GiB", "16 MB", "16  MiB", "MiB", "1.5 MiB",
                            "18446744073709551615 KiB", "1 MiB KiB"}) {
    EXPECT_EQ(notation.parse(wrong), std::nullopt) << wrong;
  }
  EXPECT_EQ(notation.print(std::size_t{64} << 10), "64 KiB");
  EXPECT_EQ(notation.print(1000), "1000");
}

TEST(OneOf, TakesItsWordsOnly) {
  constexpr std::array kChoices{std::pair<std::string_view, int>{"low", 1},
                                std::pair<std::string_view, int>{"high", 2}};
  const auto notation = one_of<int>(kChoices);
  EXPECT_EQ(notation.expected, "low or high");
  EXPECT_EQ(notation.parse("high"), 2);
  EXPECT_EQ(notation.parse("High"), std::nullopt);
  EXPECT_EQ(notation.parse(""), std::nullopt);
  EXPECT_EQ(notation.print(1), "low");
}

TEST(PathOrNone, IsEmptyForNone) {
  const auto notation = path_or_none("a file", "FILE");
  EXPECT_EQ(notation.expected, "the path of a file, or none");
  EXPECT_EQ(notation.parse("none"), "");
  EXPECT_EQ(notation.parse("a b/none"), "a b/none");
  EXPECT_EQ(notation.parse(""), std::nullopt);
  EXPECT_EQ(notation.parse("a\nb"), std::nullopt);
  EXPECT_EQ(notation.print(""), "none");
}

TEST(Ipv4Address, IsFourNumbers) {
  for (const char* right : {"127.0.0.1", "0.0.0.0", "255.255.255.255"}) {
    EXPECT_TRUE(is_ipv4(right)) << right;
  }
  for (const char* wrong : {"", "127.0.0", "127.0.0.1.1", "256.0.0.1", "localhost", "127.0.0.1:80",
                            "::1", "127..0.1"}) {
    EXPECT_FALSE(is_ipv4(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace accord
