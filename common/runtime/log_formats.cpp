#include "common/runtime/log_formats.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/pattern_formatter.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/io/words.h"

namespace accord {
namespace {

// With its quotes.
std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// Control characters, line feeds first of all, and what is no UTF-8 as \x0A.
std::string printable(std::string_view text) {
  const std::string quoted = in_quotes(text, std::numeric_limits<std::size_t>::max());
  return quoted.substr(1, quoted.size() - 2);
}

// Numbers and truth as JSON and people write them.
std::string plain(double number) {
  return std::isfinite(number) ? fmt::format("{}", number) : "null";  // JSON has no others
}
std::string plain(bool is_so) {
  return is_so ? "true" : "false";
}
template <std::integral Integer>
std::string plain(Integer number) {
  return std::to_string(number);
}

std::string json_value(const LogField::Value& value) {
  return std::visit(
      [](const auto& held) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::string>) {
          return json_string(held);
        } else {
          return plain(held);
        }
      },
      value);
}

std::string text_value(const LogField::Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return json_value(value);
  const auto is_plain = [](char c) { return c > ' ' && c != '"' && c != '=' && c != '\x7F'; };
  const bool bare = !text->empty() && std::ranges::all_of(*text, is_plain);
  return bare ? *text : json_string(*text);
}

// Message and fields of a line of text.
class MessageAndFields final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& line, const std::tm&,
              spdlog::memory_buf_t& out) override {
    out.append(printable({line.payload.data(), line.payload.size()}));
    for (const LogField* field : present_log_fields()) {
      fmt::format_to(fmt::appender(out), " {}={}", field->key, text_value(field->value));
    }
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<MessageAndFields>();
  }
};

class JsonLines final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& line, spdlog::memory_buf_t& out) override {
    using std::chrono::milliseconds;
    const auto since = line.time.time_since_epoch();
    const auto fraction = std::chrono::floor<milliseconds>(since).count() % 1000;
    const auto level = spdlog::level::to_string_view(line.level);
    fmt::format_to(
        fmt::appender(out),
        R"({{"time":"{:%Y-%m-%dT%H:%M:%S}.{:03}Z","level":"{}","process":{},"message":{})",
        fmt::gmtime(std::chrono::system_clock::to_time_t(line.time)), fraction,
        std::string_view(level.data(), level.size()),
        json_string({line.logger_name.data(), line.logger_name.size()}),
        json_string({line.payload.data(), line.payload.size()}));
    for (const LogField* field : present_log_fields()) {
      fmt::format_to(fmt::appender(out), ",{}:{}", json_string(field->key),
                     json_value(field->value));
    }
    out.append(std::string_view("}\n"));
  }
  std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<JsonLines>();
  }
};

}  // namespace

std::unique_ptr<spdlog::formatter> make_log_formatter(LogFormat format) {
  if (format == LogFormat::kJson) return std::make_unique<JsonLines>();
  auto text = std::make_unique<spdlog::pattern_formatter>();
  text->add_flag<MessageAndFields>('*').set_pattern("[%Y-%m-%d %H:%M:%S.%e] [%n] [%^%l%$] %*");
  return text;
}

}  // namespace accord
