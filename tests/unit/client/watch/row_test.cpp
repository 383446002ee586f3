#include "client/watch/row.h"

#include <gtest/gtest.h>

#include <limits>

namespace accord {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const Row kRow{
    {"id", "request", std::string("a")},
    {"rounds", "round", std::uint64_t{5}},
    {"accepting", "accepting", true},
    {"elapsed", "elapsed", Seconds{1.25}},
};

TEST(Row, IsALineOfNamedValues) {
  EXPECT_EQ(line_of("request", kRow), "request id=a rounds=5 accepting=true elapsed=1.250");
}

TEST(Row, IsAnObjectOfJson) {
  EXPECT_EQ(json_of("request", kRow),
            R"({"kind": "request", "id": "a", "rounds": 5, "accepting": true, "elapsed": 1.250})");
  EXPECT_EQ(json_of("request", {{"id", "", std::string("a")}}, "noon"),
            R"({"kind": "request", "time": "noon", "id": "a"})");
}

TEST(Row, SaysNothingOfWhatIsNotKnownInLinesAndNullInJson) {
  const Row row{{"outcome", "", std::string()}, {"makespan", "", Seconds{kNaN}}};
  EXPECT_EQ(line_of("request", row), "request");
  EXPECT_EQ(json_of("request", row), R"({"kind": "request", "outcome": "", "makespan": null})");
}

TEST(Row, KeepsLinesOneLineWhateverANameHolds) {
  const Row row{{"host", "host", std::string("a b\x1B[2J\n\xFFü=\"")}};
  EXPECT_EQ(line_of("worker", row), R"(worker host="a b\u001b[2J\n\ufffd\u00fc=\"")");
  EXPECT_EQ(json_of("worker", row),
            R"({"kind": "worker", "host": "a b\u001b[2J\n\ufffd\u00fc=\""})");
  EXPECT_EQ(cell_of(row[0]), R"(a b\x1B[2J\x0A\xFF\xC3\xBC=")");
}

TEST(Row, HasCellsForPeople) {
  const auto cell = [](auto value) { return cell_of({"", "", value}); };
  EXPECT_EQ(cell(true), "yes");
  EXPECT_EQ(cell(Seconds{1.25}), "1.2 s");
  EXPECT_EQ(cell(Seconds{3723.9}), "1:02:03");
  EXPECT_EQ(cell(Seconds{kNaN}), "?");
  EXPECT_EQ(cell(Seconds{1e300}), "?");
  EXPECT_EQ(cell(std::string(1000, 'x')).size(), 200U);
}

}  // namespace
}  // namespace accord
