#include "client/service_options.h"

#include "common/runtime/configuration.h"
#include "common/transport/dds_settings.h"

namespace accord {

ServiceOptions::ServiceOptions(std::size_t segment_bytes) {
  dds_.segment_bytes = segment_bytes;
  add_dds_settings(table_, dds_);
}

void ServiceOptions::add_to(CLI::App& command) {
  for (const Setting& setting : table_.all()) {
    command
        .add_option(setting.flag, flags_[setting.flag],
                    setting.help + " [" + setting.initial + "; " + variable_of(setting) + "]")
        ->type_name(setting.placeholder)
        ->group("Service");
  }
}

const DdsOptions& ServiceOptions::resolve() {
  Written written{std::nullopt, process_environment(), flags_};
  std::erase_if(written.flags, [](const auto& entry) { return entry.second.empty(); });
  const WrittenFaults faults = configure(table_, written);
  if (!faults.usage.empty()) throw CLI::ValidationError(faults.usage.front());
  return dds_;
}

}  // namespace accord
