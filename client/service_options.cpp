#include "client/service_options.h"

#include "common/transport/dds_settings.h"

namespace accord {
namespace {

// A client sends little: less than a service, and less than containers have.
constexpr std::size_t kSegmentBytes = std::size_t{16} << 20;

}  // namespace

ServiceOptions::ServiceOptions() {
  dds_.segment_bytes = kSegmentBytes;
  add_dds_settings(table_, dds_);
}

void ServiceOptions::add_to(CLI::App& command) {
  flags_.add_to(command, table_, "Service");
}

const DdsOptions& ServiceOptions::resolve() {
  flags_.resolve(table_);
  return dds_;
}

}  // namespace accord
