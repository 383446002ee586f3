#include "client/service_options.h"

#include "common/transport/dds_settings.h"

namespace accord {

ServiceOptions::ServiceOptions(std::size_t segment_bytes) {
  dds_.segment_bytes = segment_bytes;
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
