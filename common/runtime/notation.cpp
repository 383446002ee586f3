#include "common/runtime/notation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "common/io/fields.h"
#include "common/io/words.h"

namespace accord {
namespace {

struct Unit {
  std::string_view name;
  std::size_t bytes;
};
constexpr std::array kUnits{Unit{"GiB", std::size_t{1} << 30}, Unit{"MiB", std::size_t{1} << 20},
                            Unit{"KiB", std::size_t{1} << 10}};

std::optional<std::uint64_t> number_in(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

// Without an exponent, for as long as anybody waits.
std::string print_seconds(double value) {
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%.10g", value);
  return out.data();
}

std::string print_bytes(std::size_t value) {
  for (const Unit& unit : kUnits) {
    if (value > 0 && value % unit.bytes == 0) {
      return std::to_string(value / unit.bytes) + " " + std::string(unit.name);
    }
  }
  return std::to_string(value);
}

std::optional<std::size_t> parse_bytes(std::string_view text) {
  std::size_t factor = 1;
  for (const Unit& unit : kUnits) {
    if (!text.ends_with(unit.name)) continue;
    factor = unit.bytes;
    text.remove_suffix(unit.name.size());
    if (text.ends_with(' ')) text.remove_suffix(1);
  }
  const auto count = number_in(text);
  if (!count || *count > std::numeric_limits<std::size_t>::max() / factor) return std::nullopt;
  return *count * factor;
}

bool may_be_a_path(std::string_view text) {
  return !text.empty() && first_unprintable(text) == std::string_view::npos &&
         text.find_first_of("\t\r\n") == std::string_view::npos;
}

}  // namespace

namespace detail {

Notation<std::uint64_t> whole_number(std::uint64_t min, std::uint64_t max) {
  return {"a whole number from " + std::to_string(min) + " to " + std::to_string(max), "N",
          [min, max](std::string_view text) -> std::optional<std::uint64_t> {
            const auto value = number_in(text);
            return value && *value >= min && *value <= max ? value : std::nullopt;
          },
          [](const std::uint64_t& value) { return std::to_string(value); }};
}

Notation<std::size_t> one_of(std::vector<std::string> words) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  return {alternatives(views), "WORD",
          [words](std::string_view text) -> std::optional<std::size_t> {
            const auto found = std::ranges::find(words, text);
            if (found == words.end()) return std::nullopt;
            return static_cast<std::size_t>(found - words.begin());
          },
          [words](const std::size_t& index) { return words[index]; }, true};
}

}  // namespace detail

Notation<double> seconds(double min, double max) {
  return {"a number from " + print_seconds(min) + " to " + print_seconds(max) + " s", "SECONDS",
          [min, max](std::string_view text) -> std::optional<double> {
            const auto value = parse_number(text);
            return value && *value >= min && *value <= max ? value : std::nullopt;
          },
          [](const double& value) { return print_seconds(value); }};
}

Notation<std::chrono::milliseconds> rounded_seconds(std::chrono::milliseconds min,
                                                    std::chrono::milliseconds max) {
  constexpr double kMilli = 1e-3;
  const Notation<double> exact =
      seconds(static_cast<double>(min.count()) * kMilli, static_cast<double>(max.count()) * kMilli);
  return {exact.expected, exact.placeholder,
          [exact](std::string_view text) -> std::optional<std::chrono::milliseconds> {
            const auto value = exact.parse(text);
            if (!value) return std::nullopt;
            return std::chrono::milliseconds(std::llround(*value / kMilli));
          },
          [exact](const std::chrono::milliseconds& value) {
            return exact.print(static_cast<double>(value.count()) * kMilli);
          }};
}

Notation<std::size_t> bytes(std::size_t min, std::size_t max) {
  return {"a size from " + print_bytes(min) + " to " + print_bytes(max), "BYTES",
          [min, max](std::string_view text) -> std::optional<std::size_t> {
            const auto value = parse_bytes(text);
            return value && *value >= min && *value <= max ? value : std::nullopt;
          },
          [](const std::size_t& value) { return print_bytes(value); }};
}

Notation<std::string> text(std::string expected, std::string placeholder,
                           std::function<bool(std::string_view)> is_sound) {
  return {std::move(expected), std::move(placeholder),
          [is_sound = std::move(is_sound)](std::string_view value) -> std::optional<std::string> {
            if (!is_sound(value)) return std::nullopt;
            return std::string(value);
          },
          [](const std::string& value) { return value; }, true};
}

bool is_ipv4(std::string_view text) {
  for (int part = 0; part < 4; ++part) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value > 255) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (part == 3) return text.empty();
    if (!text.starts_with('.')) return false;
    text.remove_prefix(1);
  }
  return false;
}

Notation<std::string> ipv4_address() {
  return text("an IPv4 address", "IP", is_ipv4);
}

Notation<std::string> path_or_none(std::string_view of_what, std::string placeholder) {
  return {"the path of " + std::string(of_what) + ", or none", std::move(placeholder),
          [](std::string_view value) -> std::optional<std::string> {
            if (!may_be_a_path(value)) return std::nullopt;
            return value == "none" ? std::string() : std::string(value);
          },
          [](const std::string& value) { return value.empty() ? "none" : value; }, true};
}

}  // namespace accord
