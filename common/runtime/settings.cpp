#include "common/runtime/settings.h"

#include <algorithm>

namespace accord {

std::string variable_of(const Setting& setting) {
  std::string name = "ACCORD_";
  for (const char c : setting.key) {
    name += c == '.' ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return name;
}

const Setting* Settings::find(std::string_view key) const {
  const auto found = std::ranges::find(all_, key, &Setting::key);
  return found == all_.end() ? nullptr : &*found;
}

std::vector<SettingFault> Settings::failed_checks() const {
  std::vector<SettingFault> faults;
  for (const auto& check : checks_) {
    if (auto fault = check()) faults.push_back(std::move(*fault));
  }
  return faults;
}

}  // namespace accord
