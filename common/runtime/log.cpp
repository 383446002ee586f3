#include "common/runtime/log.h"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "common/runtime/log_formats.h"

namespace accord {
namespace {

thread_local const LogScope* innermost = nullptr;

spdlog::level::level_enum level_of(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return spdlog::level::debug;
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kWarning:
      return spdlog::level::warn;
    case LogLevel::kError:
      return spdlog::level::err;
    case LogLevel::kOff:
      break;
  }
  return spdlog::level::off;
}

}  // namespace

void start_log(const std::string& process, const LogOptions& options) {
  auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  sink->set_formatter(make_log_formatter(options.format));
  auto logger = std::make_shared<spdlog::logger>(process, std::move(sink));
  logger->set_level(level_of(options.level));
  spdlog::set_default_logger(std::move(logger));
}

LogScope::LogScope(std::initializer_list<LogField> fields)
    : LogScope(std::vector<LogField>(fields)) {}

LogScope::LogScope(std::vector<LogField> fields) : fields_(std::move(fields)), outer_(innermost) {
  innermost = this;
}

LogScope::~LogScope() {
  innermost = outer_;
}

bool logs(LogLevel level) {
  return spdlog::should_log(level_of(level));
}

void log(LogLevel level, std::string_view message, std::initializer_list<LogField> fields) {
  if (logs(level)) log(level, message, std::vector<LogField>(fields));
}

void log(LogLevel level, std::string_view message, std::vector<LogField> fields) {
  if (!logs(level)) return;
  const LogScope scope(std::move(fields));
  spdlog::log(level_of(level), spdlog::string_view_t(message.data(), message.size()));
}

std::vector<const LogField*> present_log_fields() {
  std::vector<const LogField*> present;
  for (const LogScope* scope = innermost; scope != nullptr; scope = scope->outer_) {
    for (auto field = scope->fields_.rbegin(); field != scope->fields_.rend(); ++field) {
      const auto same = [&](const LogField* other) { return other->key == field->key; };
      if (std::ranges::none_of(present, same)) present.push_back(&*field);
    }
  }
  std::ranges::reverse(present);
  return present;
}

}  // namespace accord
