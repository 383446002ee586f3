#include "common/io/wire/inspector.h"

#include <google/protobuf/repeated_field.h>

#include <cmath>

#include "common/io/words.h"

namespace accord {
namespace {

std::string range_in_words(Range range) {
  std::string out = in_words(range.min) + " to " + in_words(range.max);
  if (!range.unit.empty()) out += " " + std::string(range.unit);
  return out;
}

bool lies_within(double value, Range range) {
  return value >= range.min && value <= range.max;  // not so for NaN
}

}  // namespace

bool Inspector::fail(const PayloadPath& at, std::string_view text) {
  if (!fault_) {
    const std::string where = at.in_words();
    fault_ = where.empty() ? std::string(text) : where + ": " + std::string(text);
  }
  return false;
}

bool Inspector::number(double value, Range range, const PayloadPath& at) {
  if (lies_within(value, range)) return true;
  return fail(at, "expected " + range_in_words(range) + ", not " + in_words(value));
}

bool Inspector::number_or_infinity(double value, Range range, const PayloadPath& at) {
  if (value == std::numeric_limits<double>::infinity() || lies_within(value, range)) return true;
  return fail(at, "expected " + range_in_words(range) + " or infinity, not " + in_words(value));
}

bool Inspector::count(std::uint64_t value, std::uint64_t least, std::uint64_t most,
                      std::string_view of_what, const PayloadPath& at) {
  if (value >= least && value <= most) return true;
  const std::string expected =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  std::string text = "expected " + expected;
  if (!of_what.empty()) text += " " + std::string(of_what);
  return fail(at, text + ", not " + std::to_string(value));
}

bool Inspector::index(std::uint64_t value, std::uint64_t size, std::string_view of_what,
                      const PayloadPath& at) {
  if (value < size) return true;
  return fail(at, "there is no " + std::string(of_what) + " " + std::to_string(value) +
                      "; there are " + std::to_string(size) + ", from 0");
}

bool Inspector::name(std::string_view value, const PayloadPath& at, std::size_t most) {
  if (value.empty() || value.size() > most) {
    return fail(at, "expected a name of 1 to " + std::to_string(most) + " bytes, not " +
                        std::to_string(value.size()));
  }
  if (value.find_first_of("\t\r\n") == std::string_view::npos &&
      first_unprintable(value) == std::string_view::npos) {
    return true;
  }
  return fail(at, "expected UTF-8 without control characters, not " + in_quotes(value));
}

bool Inspector::numbers(const WireDoubles& values, std::size_t size, Range range,
                        const PayloadPath& at) {
  const auto found = static_cast<std::size_t>(values.size());
  if (!count(found, size, size, "numbers", at)) return false;
  for (std::size_t i = 0; i < found; ++i) {
    const double value = values.Get(static_cast<int>(i));
    if (!lies_within(value, range)) return number(value, range, PayloadPath(at, "", i));
  }
  return true;
}

bool Inspector::pose(const WireDoubles& values, double reach, const PayloadPath& at, Pose& out) {
  constexpr double kRounding = 1e-9;
  if (!numbers(values, 12, {-reach, reach, ""}, at)) return false;
  out = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      out.matrix()(row, column) = values.Get(4 * row + column);
    }
  }
  const Eigen::Matrix3d r = out.linear();
  const bool turns =
      (r.transpose() * r - Eigen::Matrix3d::Identity()).norm() <= kRounding && r.determinant() > 0;
  return turns || fail(at, "its first three columns must be a rotation");
}

bool Inspector::direction(const WireDoubles& values, const PayloadPath& at, Vec3& out) {
  constexpr double kRounding = 1e-9;
  if (!numbers(values, 3, {-2, 2, ""}, at)) return false;
  out = {values.Get(0), values.Get(1), values.Get(2)};
  return std::abs(out.norm() - 1) <= kRounding ||
         fail(at, "expected a direction of length 1, not " + in_words(out.norm()));
}

}  // namespace accord
