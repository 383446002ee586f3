// How the value of a setting is written: the same text in a file, an environment variable and a
// flag. Pure; thread safe.
#pragma once

#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace accord {

// parse() and print() are inverse: what one printed, the other takes.
template <typename T>
struct Notation {
  std::string expected;     // as in "expected a whole number from 1 to 1024"
  std::string placeholder;  // for a value, in a list of flags: "N"
  std::function<std::optional<T>(std::string_view)> parse;  // nullopt: not such a value
  std::function<std::string(const T&)> print;
  bool is_text = false;  // a file may put it in quotes; numbers stand without
};

namespace detail {
Notation<std::uint64_t> whole_number(std::uint64_t min, std::uint64_t max);
Notation<std::size_t> one_of(std::vector<std::string> words);
}  // namespace detail

// Decimal digits only.
template <std::unsigned_integral Integer>
Notation<Integer> whole_number(Integer min, Integer max) {
  const Notation<std::uint64_t> wide = detail::whole_number(min, max);
  return {wide.expected, wide.placeholder,
          [wide](std::string_view text) -> std::optional<Integer> {
            const auto value = wide.parse(text);
            if (!value) return std::nullopt;
            return static_cast<Integer>(*value);
          },
          [](const Integer& value) { return std::to_string(value); }};
}

// Seconds, such as 0.25. Bounds are included.
Notation<double> seconds(double min, double max);
// The same, for whole milliseconds: 0.25 is 250, finer parts are rounded.
Notation<std::chrono::milliseconds> rounded_seconds(std::chrono::milliseconds min,
                                                    std::chrono::milliseconds max);

// A size in bytes, such as 65536, 64 KiB, 16MiB or 1 GiB.
Notation<std::size_t> bytes(std::size_t min, std::size_t max);

// Text that `is_sound` holds for.
Notation<std::string> text(std::string expected, std::string placeholder,
                           std::function<bool(std::string_view)> is_sound);

// Four numbers, as in 127.0.0.1; no name of a machine.
bool is_ipv4(std::string_view text);
Notation<std::string> ipv4_address();

// The path of a file or a folder, or the word "none", which stands for an empty string.
// `of_what`: "a file" or "a folder".
Notation<std::string> path_or_none(std::string_view of_what, std::string placeholder);

// One of some words, each of which stands for a value. A value without a word prints as nothing.
template <typename T>
Notation<T> one_of(std::span<const std::pair<std::string_view, T>> choices) {
  std::vector<std::string> words;
  std::vector<T> values;
  for (const auto& [word, value] : choices) {
    words.emplace_back(word);
    values.push_back(value);
  }
  const Notation<std::size_t> index = detail::one_of(words);
  return {index.expected, index.placeholder,
          [index, values](std::string_view text) -> std::optional<T> {
            const auto found = index.parse(text);
            if (!found) return std::nullopt;
            return values[*found];
          },
          [words, values](const T& value) -> std::string {
            for (std::size_t i = 0; i < values.size(); ++i) {
              if (values[i] == value) return words[i];
            }
            return "";
          },
          true};
}

}  // namespace accord
