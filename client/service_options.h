// Flags that say where the service is, and the environment variables that stand for them: those
// that coordinator and workers have, too (docs/operations.md).
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>

#include "client/setting_flags.h"
#include "common/runtime/settings.h"
#include "common/transport/dds_options.h"

namespace accord {

// A client sends little: less than a service, and less than containers have.
inline constexpr std::size_t kClientSegmentBytes = std::size_t{16} << 20;

class ServiceOptions {
 public:
  explicit ServiceOptions(std::size_t segment_bytes = kClientSegmentBytes);
  ServiceOptions(const ServiceOptions&) = delete;
  ServiceOptions& operator=(const ServiceOptions&) = delete;

  // Must outlive the command.
  void add_to(CLI::App& command);
  // What was said, once the command line is read. Throws CLI::ValidationError.
  const DdsOptions& resolve();

 private:
  DdsOptions dds_;
  Settings table_;
  SettingFlags flags_;
};

}  // namespace accord
