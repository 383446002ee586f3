#include "client/setting_flags.h"

#include "common/runtime/configuration.h"

namespace accord {

void SettingFlags::add_to(CLI::App& command, const Settings& table, const std::string& group) {
  for (const Setting& setting : table.all()) {
    command
        .add_option(setting.flag, flags_[setting.flag],
                    setting.help + " [" + setting.initial + "; " + variable_of(setting) + "]")
        ->type_name(setting.placeholder)
        ->group(group);
  }
}

void SettingFlags::resolve(const Settings& table) {
  Written written{std::nullopt, process_environment(), flags_};
  std::erase_if(written.flags, [](const auto& entry) { return entry.second.empty(); });
  const WrittenFaults faults = configure(table, written);
  if (!faults.usage.empty()) throw CLI::ValidationError(faults.usage.front());
}

}  // namespace accord
