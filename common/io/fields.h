// Reading a Document's values: maps by their known keys, numbers within ranges, points, names. Each
// function reports what is wrong with the value's file, line and path, and returns nullopt then;
// the caller goes on, so that all faults of a file are found at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/io/document.h"
#include "common/io/limits.h"

namespace accord {

Place place_of(const Value& value);
void fault_at(const Value& value, std::string_view text, Faults& faults);
// Where `key` is missing from, or wrong about, a map.
void fault_at(const Value& map, std::string_view key, std::string_view text, Faults& faults);

// What a number may be. `unit` is for messages.
struct Range {
  double min;
  double max;
  std::string_view unit;
};

// "a number from 0 to 100000 m".
std::string in_words(Range range);

inline constexpr Range kCoordinateRange{-limits::kCoordinate, limits::kCoordinate, "m"};
inline constexpr Range kSizeRange{limits::kMinSize, limits::kSize, "m"};
inline constexpr Range kAngleRange{-limits::kAngle, limits::kAngle, "rad"};

// A map whose keys are known. Construction reports keys that are unknown (with the nearest known
// one) or given twice. `what` names the thing in messages: "a robot". Requires: value.is_map().
class Fields {
 public:
  Fields(Value map, std::string_view what, std::vector<std::string_view> known, Faults& faults);

  // nullopt where the key is absent.
  std::optional<Value> find(std::string_view key) const;
  // Reports a missing key, unless an unknown key that was reported seems to mean it.
  std::optional<Value> require(std::string_view key, std::string_view expected) const;
  bool has(std::string_view key) const { return find(key).has_value(); }
  Value map() const { return map_; }

 private:
  struct Entry {
    std::string_view key;
    Value value;
  };
  void report_twice(const Value& key, int first_line);
  void report_unknown(const Value& key, const std::vector<std::string_view>& known);
  void report(const Value& key, std::string_view text);

  Value map_;
  std::string what_;
  Faults& faults_;
  std::vector<Entry> entries_;
  std::vector<std::string_view> meant_;  // known keys that unknown ones were taken for
};

// The one key of `value`, a map, that is among `kinds`: what kind of thing the map describes.
// Reports none and several, and returns nothing then. `what` is what a kind is, for messages:
// "shape".
std::string_view only_kind_of(const Value& value, std::span<const std::string_view> kinds,
                              std::string_view what, Faults& faults);

// A finite number, as YAML 1.2 and JSON write them. Silent: for those who report themselves.
// Infinity and NaN (".inf", ".nan") are numbers here.
std::optional<double> parse_number(std::string_view text);

std::optional<double> read_number(const Value& value, Range range, Faults& faults);
std::optional<double> read_number(const Value& value, Faults& faults);  // finite
std::optional<std::uint64_t> read_count(const Value& value, Faults& faults);
std::optional<bool> read_flag(const Value& value, Faults& faults);  // true, false, 0, 1

// A list of numbers of one of the sizes. `expected` describes it: "[x, y] or [x, y, z]".
std::optional<std::vector<double>> read_numbers(const Value& value,
                                                std::initializer_list<std::size_t> sizes,
                                                std::string_view expected, Range range,
                                                Faults& faults);

// Not empty, at most kNameBytes, UTF-8 without control characters.
bool is_name(std::string_view text);

// A word or a quoted string that is_name().
std::optional<std::string> read_name(const Value& value, Faults& faults);

// Reports and returns false unless the value is a list or map, respectively.
bool expect_list(const Value& value, std::string_view of_what, Faults& faults);
bool expect_map(const Value& value, std::string_view of_what, Faults& faults);

}  // namespace accord
