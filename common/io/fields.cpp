#include "common/io/fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "common/io/words.h"

namespace accord {
namespace {

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

}  // namespace

std::string in_words(Range range) {
  const std::string unit = range.unit.empty() ? "" : " " + std::string(range.unit);
  return "a number from " + in_words(range.min) + " to " + in_words(range.max) + unit;
}

Place place_of(const Value& value) {
  return {value.file(), value.line(), value.path()};
}

void fault_at(const Value& value, std::string_view text, Faults& faults) {
  if (faults.full()) return faults.add(value.file(), 0, "", "");  // only counted: paths cost time
  faults.add(place_of(value), text);
}

void fault_at(const Value& map, std::string_view key, std::string_view text, Faults& faults) {
  if (faults.full()) return faults.add(map.file(), 0, "", "");
  faults.add(map.file(), map.line(), joined(map.path(), key), text);
}

Fields::Fields(Value map, std::string_view what, std::vector<std::string_view> known,
               Faults& faults)
    : map_(map), what_(what), faults_(faults) {
  std::unordered_map<std::string_view, int> unknown;  // the line each was first seen on
  for (auto it = map.begin(); it != map.end(); ++it) {
    const Value key = *it;
    const Value value = *++it;
    const auto same = std::ranges::find(entries_, key.text(), &Entry::key);
    if (same != entries_.end()) {
      report_twice(key, same->value.line());
    } else if (std::ranges::find(known, key.text()) != known.end()) {
      entries_.push_back({key.text(), value});
    } else if (const auto [first, is_new] = unknown.emplace(key.text(), key.line()); !is_new) {
      report_twice(key, first->second);
    } else {
      report_unknown(key, known);
    }
  }
}

void Fields::report_twice(const Value& key, int first_line) {
  report(key, "given twice in " + what_ + "; the first is in line " + std::to_string(first_line));
}

void Fields::report_unknown(const Value& key, const std::vector<std::string_view>& known) {
  if (faults_.full()) return report(key, "");
  if (const auto nearest = nearest_word(key.text(), known)) meant_.push_back(*nearest);
  const std::string hint = suggestion(key.text(), known);
  report(key,
         "unknown key in " + what_ + (hint.empty() ? "; expected " + alternatives(known) : hint));
}

void Fields::report(const Value& key, std::string_view text) {
  if (faults_.full()) return faults_.add(key.file(), 0, "", "");  // only counted: paths cost time
  const std::string shown = in_quotes(key.text());
  const std::string path = joined(map_.path(), shown.substr(1, shown.size() - 2));
  faults_.add(key.file(), key.line(), path, text);
}

std::optional<Value> Fields::find(std::string_view key) const {
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found == entries_.end()) return std::nullopt;
  return found->value;
}

std::optional<Value> Fields::require(std::string_view key, std::string_view expected) const {
  const auto found = find(key);
  if (!found && std::ranges::find(meant_, key) == meant_.end()) {
    fault_at(map_, key, "missing from " + what_ + "; expected " + std::string(expected), faults_);
  }
  return found;
}

std::string_view only_kind_of(const Value& value, std::span<const std::string_view> kinds,
                              std::string_view what, Faults& faults) {
  std::string_view found;
  for (auto it = value.begin(); it != value.end(); ++it) {
    const auto kind = std::ranges::find(kinds, (*it).text());
    ++it;
    if (kind == kinds.end() || *kind == found) continue;
    if (!found.empty()) {
      fault_at(value,
               "has both " + std::string(found) + " and " + std::string(*kind) + "; expected one " +
                   std::string(what),
               faults);
      return {};
    }
    found = *kind;
  }
  if (found.empty()) {
    const std::string_view first = value.size() > 0 ? (*value.begin()).text() : std::string_view();
    fault_at(
        value,
        "expected a " + std::string(what) + ": " + alternatives(kinds) + suggestion(first, kinds),
        faults);
  }
  return found;
}

std::optional<double> parse_number(std::string_view text) {
  std::string_view digits = text;
  const bool minus = digits.starts_with('-');
  if (minus || digits.starts_with('+')) digits.remove_prefix(1);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (digits == ".inf" || digits == ".Inf" || digits == ".INF") {
    return minus ? -kInfinity : kInfinity;
  }
  if (text == ".nan" || text == ".NaN" || text == ".NAN") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // from_chars would take "inf" and "nan" without the dot, which YAML does not.
  if (digits.empty() || digits.find_first_not_of("0123456789.eE+-") != std::string_view::npos) {
    return std::nullopt;
  }
  if (digits[0] == '+' || digits[0] == '-') return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small for a double is zero; too large is infinity, which no reader accepts.
    const bool tiny =
        digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos;
    value = tiny ? 0.0 : kInfinity;
  } else if (error != std::errc()) {
    return std::nullopt;
  }
  return minus ? -value : value;
}

std::optional<double> read_number(const Value& value, Faults& faults) {
  const auto number = value.kind() == ValueKind::kPlain ? parse_number(value.text()) : std::nullopt;
  if (!number) {
    fault_at(value, "expected a number, not " + value.in_words(), faults);
    return std::nullopt;
  }
  if (!std::isfinite(*number)) {
    fault_at(value, "expected a finite number, not " + std::string(value.text()), faults);
    return std::nullopt;
  }
  return number;
}

std::optional<double> read_number(const Value& value, Range range, Faults& faults) {
  const auto number = read_number(value, faults);
  if (!number || (*number >= range.min && *number <= range.max)) return number;
  std::string text = "expected " + in_words(range) + ", not ";
  const std::string unit = range.unit.empty() ? "" : " " + std::string(range.unit);
  if (range.min > 0 && *number <= 0) text = "must be greater than 0" + unit + ", not ";
  if (range.min == 0 && *number < 0) text = "must not be less than 0" + unit + ", but is ";
  fault_at(value, text + std::string(value.text()), faults);
  return std::nullopt;
}

std::optional<std::uint64_t> read_count(const Value& value, Faults& faults) {
  std::uint64_t count = 0;
  const std::string_view text = value.text();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (value.kind() != ValueKind::kPlain || error != std::errc() || text.empty() ||
      end != text.data() + text.size()) {
    fault_at(value, "expected a whole number from 0, not " + value.in_words(), faults);
    return std::nullopt;
  }
  return count;
}

std::optional<bool> read_flag(const Value& value, Faults& faults) {
  const std::string_view text = value.text();
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  fault_at(value, "expected true or false, not " + value.in_words(), faults);
  return std::nullopt;
}

std::optional<std::vector<double>> read_numbers(const Value& value,
                                                std::initializer_list<std::size_t> sizes,
                                                std::string_view expected, Range range,
                                                Faults& faults) {
  if (!value.is_list() || std::ranges::find(sizes, value.size()) == sizes.end()) {
    fault_at(value, "expected " + std::string(expected) + ", not " + value.in_words(), faults);
    return std::nullopt;
  }
  std::vector<double> numbers;
  bool sound = true;
  for (const Value item : value) {
    const auto number = read_number(item, range, faults);
    sound = sound && number;
    numbers.push_back(number.value_or(0));
  }
  if (!sound) return std::nullopt;
  return numbers;
}

namespace {

bool has_control_characters(std::string_view text) {
  return text.find_first_of("\t\r\n") != std::string_view::npos ||
         first_unprintable(text) != std::string_view::npos;
}

}  // namespace

bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= limits::kNameBytes && !has_control_characters(text);
}

std::optional<std::string> read_name(const Value& value, Faults& faults) {
  if (!value.is_scalar() || value.text().empty()) {
    fault_at(value, "expected a name, not " + (value.is_scalar() ? "\"\"" : value.in_words()),
             faults);
    return std::nullopt;
  }
  const std::string_view text = value.text();
  if (text.size() > limits::kNameBytes) {
    fault_at(value,
             "a name of " + std::to_string(text.size()) + " bytes; expected at most " +
                 std::to_string(limits::kNameBytes),
             faults);
    return std::nullopt;
  }
  if (has_control_characters(text)) {
    fault_at(value, "expected a name without control characters, not " + in_quotes(text), faults);
    return std::nullopt;
  }
  return std::string(text);
}

bool expect_list(const Value& value, std::string_view of_what, Faults& faults) {
  if (value.is_list()) return true;
  fault_at(value, "expected a list of " + std::string(of_what) + ", not " + value.in_words(),
           faults);
  return false;
}

bool expect_map(const Value& value, std::string_view of_what, Faults& faults) {
  if (value.is_map()) return true;
  fault_at(value, "expected " + std::string(of_what) + ", not " + value.in_words(), faults);
  return false;
}

}  // namespace accord
