// The words that messages are made of. Pure functions; thread safe.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace accord {

// Safe to print: control characters and what is not UTF-8 escaped, cut with "..." where longer. The
// dots and the last escape may come on top of `max_bytes`, 6 bytes.
std::string printable(std::string_view text, std::size_t max_bytes);

// In double quotes, safe to print: control characters escaped, cut with "..." where longer.
std::string in_quotes(std::string_view text, std::size_t max_bytes = 60);

// Up to six significant digits: 0.14, 12, 1e-09.
std::string in_words(double value);

// "a, b or c".
std::string alternatives(std::span<const std::string_view> words);

// The candidate that is most likely meant by a mistyped word; nullopt where none is near.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> candidates);

// `; did you mean "speed"?`, or nothing where no candidate is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

// The byte at which text stops being UTF-8 without control characters (tab, line feed and carriage
// return are fine); npos where all of it is.
std::size_t first_unprintable(std::string_view text);

// The line, from 1, that the byte at `position` is in.
int line_at(std::string_view text, std::size_t position);

}  // namespace accord
