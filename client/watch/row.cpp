#include "client/watch/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "client/terminal_text.h"

namespace accord {
namespace {

constexpr std::size_t kCell = 200;

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string clock_of(double seconds) {
  if (!(std::abs(seconds) < 1e12)) return "?";  // whoever says so
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<std::uint64_t>(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

// Numbers and truth as JSON has them.
std::string plain(std::uint64_t number) {
  return std::to_string(number);
}
std::string plain(bool is_so) {
  return is_so ? "true" : "false";
}
std::string plain(Seconds seconds) {
  if (!std::isfinite(seconds.count)) return "null";
  return fmt::format("{:.3f}", seconds.count);
}

std::string json_value(const Field& field) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
          return json_string(value);
        } else {
          return plain(value);
        }
      },
      field.value);
}

std::string line_value(const Field& field) {
  const auto* text = std::get_if<std::string>(&field.value);
  if (text == nullptr) return json_value(field);
  const auto is_plain = [](char c) {
    return c > ' ' && c < '\x7F' && c != '"' && c != '=' && c != '\\';
  };
  const bool is_bare = !text->empty() && std::ranges::all_of(*text, is_plain);
  return is_bare ? *text : json_string(*text);
}

}  // namespace

bool Field::is_empty() const {
  if (const auto* text = std::get_if<std::string>(&value)) return text->empty();
  const auto* seconds = std::get_if<Seconds>(&value);
  return seconds != nullptr && !std::isfinite(seconds->count);
}

std::string cell_of(const Field& field) {
  if (const auto* text = std::get_if<std::string>(&field.value)) {
    return terminal_text(*text, kCell);
  }
  if (const auto* is_so = std::get_if<bool>(&field.value)) return *is_so ? "yes" : "no";
  if (const auto* seconds = std::get_if<Seconds>(&field.value)) return clock_of(seconds->count);
  return std::to_string(std::get<std::uint64_t>(field.value));
}

std::string line_of(std::string_view kind, const Row& row) {
  std::string out(kind);
  for (const Field& field : row) {
    if (!field.is_empty()) out += fmt::format(" {}={}", field.name, line_value(field));
  }
  return out;
}

std::string json_of(std::string_view kind, const Row& row, std::string_view time) {
  std::string out = fmt::format(R"({{"kind": "{}")", kind);
  if (!time.empty()) out += fmt::format(R"(, "time": "{}")", time);
  for (const Field& field : row) out += fmt::format(R"(, "{}": {})", field.name, json_value(field));
  return out + "}";
}

}  // namespace accord
