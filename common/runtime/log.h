// The log of a process: where it goes, from which level on, and as what. Lines are written with
// spdlog's functions, or with log() below. A line can carry fields, such as the request that it is
// about: as key=value behind the message, or as members of a JSON object.
//
// Thread safe, but for start_log(), which comes before other threads.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace accord {

enum class LogLevel { kDebug, kInfo, kWarning, kError, kOff };
enum class LogFormat {
  kText,  // [2026-11-25 17:01:44.123] [accord-worker] [info] message key=value, in local time
  kJson,  // a line an object: time (UTC, RFC 3339), level, process, message, then the fields
};

// What people call them, on every command line and in every file.
inline constexpr std::array kLogLevels{
    std::pair<std::string_view, LogLevel>{"debug", LogLevel::kDebug},
    std::pair<std::string_view, LogLevel>{"info", LogLevel::kInfo},
    std::pair<std::string_view, LogLevel>{"warning", LogLevel::kWarning},
    std::pair<std::string_view, LogLevel>{"error", LogLevel::kError},
    std::pair<std::string_view, LogLevel>{"off", LogLevel::kOff}};
inline constexpr std::array kLogFormats{
    std::pair<std::string_view, LogFormat>{"text", LogFormat::kText},
    std::pair<std::string_view, LogFormat>{"json", LogFormat::kJson}};

struct LogOptions {
  LogLevel level = LogLevel::kInfo;  // the least that is written
  LogFormat format = LogFormat::kText;
};

// From now on all lines go to stderr, as the options say. May be called again.
void start_log(const std::string& process, const LogOptions& options);

struct LogField {
  using Value = std::variant<std::string, std::int64_t, std::uint64_t, double, bool>;

  LogField(std::string_view name, std::string text) : key(name), value(std::move(text)) {}
  LogField(std::string_view name, std::string_view text) : key(name), value(std::string(text)) {}
  LogField(std::string_view name, const char* text) : key(name), value(std::string(text)) {}
  LogField(std::string_view name, double number) : key(name), value(number) {}
  LogField(std::string_view name, bool is_so) : key(name), value(is_so) {}
  template <std::signed_integral Integer>
  LogField(std::string_view name, Integer number) : key(name), value(std::int64_t{number}) {}
  template <std::unsigned_integral Integer>
  LogField(std::string_view name, Integer number) : key(name), value(std::uint64_t{number}) {}

  // A word of letters and '_' that lives as long as the program; none of time, level, process and
  // message.
  std::string_view key;
  Value value;
};

// While it lives, every line that its thread logs carries these fields. Scopes nest, and are left
// in reverse order; where one has a key of an outer one, it counts.
//
//     const LogScope of_request({{"request", id}});
//     spdlog::info("planned in {:.1f} s", time);
class LogScope {
 public:
  LogScope(std::initializer_list<LogField> fields);
  explicit LogScope(std::vector<LogField> fields);
  ~LogScope();
  LogScope(const LogScope&) = delete;
  LogScope& operator=(const LogScope&) = delete;

 private:
  friend std::vector<const LogField*> present_log_fields();
  std::vector<LogField> fields_;
  const LogScope* outer_;
};

// Whether lines of this level are written. Requires: it is not kOff.
bool logs(LogLevel level);

// One line with fields of its own. Requires: level is not kOff.
void log(LogLevel level, std::string_view message, std::initializer_list<LogField> fields);
void log(LogLevel level, std::string_view message, std::vector<LogField> fields);

// The fields of this thread's scopes, from the outermost on, each key once. For formatters.
std::vector<const LogField*> present_log_fields();

}  // namespace accord
