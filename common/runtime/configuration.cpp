#include "common/runtime/configuration.h"

#include <algorithm>
#include <string_view>

#include <unistd.h>

#include "common/io/words.h"
#include "common/runtime/settings_file.h"

namespace accord {
namespace {

constexpr std::string_view kPrefix = "ACCORD_";

// Where a setting has its value from, for whoever finds later that it goes ill with another.
struct Origin {
  std::string name;  // "--domain", "ACCORD_DDS_DOMAIN", "worker.yaml:3: dds.domain"
  bool is_file = false;
};

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> items;
  while (true) {
    const std::size_t comma = list.find(',');
    items.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) return items;
    list.remove_prefix(comma + 1);
  }
}

class Configuration {
 public:
  Configuration(const Settings& settings, const Written& written)
      : settings_(settings), written_(written) {}

  WrittenFaults read() {
    read_file();
    for (const Setting& setting : settings_.all()) {
      read_variable(setting);
      read_flag(setting);
    }
    warn_of_unknown_variables();
    if (faults_.none()) check();
    return std::move(faults_);
  }

 private:
  void read_file() {
    if (!written_.file) return;
    Faults faults(written_.file->string());
    for (FileEntry& entry : read_settings_file(settings_, *written_.file, faults)) {
      entry.setting->assign(entry.values);
      const Diagnostic where{entry.place.file, entry.place.line, "", entry.place.key};
      origins_[entry.setting->key] = {to_string(where), true};
    }
    for (const Diagnostic& fault : faults.take()) faults_.file.push_back(to_string(fault));
  }

  void read_variable(const Setting& setting) {
    const std::string name = variable_of(setting);
    const auto found = written_.variables.find(name);
    if (found == written_.variables.end() || found->second.empty()) return;
    set(setting, name, setting.is_list ? split(found->second) : std::vector{found->second});
  }

  void read_flag(const Setting& setting) {
    const auto found = written_.flags.find(setting.flag);
    if (found == written_.flags.end()) return;
    const std::vector<std::string>& given = found->second;
    if (!setting.is_list) {
      if (given.size() > 1) {
        faults_.usage.push_back(setting.flag + ": given " + std::to_string(given.size()) +
                                " times; expected once");
      }
      return set(setting, setting.flag, given);
    }
    std::vector<std::string> items;
    for (const std::string& list : given) std::ranges::move(split(list), std::back_inserter(items));
    set(setting, setting.flag, items);
  }

  void set(const Setting& setting, const std::string& name,
           const std::vector<std::string>& values) {
    bool sound = true;
    for (const std::string& value : values) {
      if (setting.accepts(value)) continue;
      faults_.usage.push_back(name + ": expected " + setting.expected + ", not " +
                              in_quotes(value));
      sound = false;
    }
    if (!sound) return;
    setting.assign(values);
    origins_[setting.key] = {name};
  }

  void warn_of_unknown_variables() {
    std::vector<std::string> names;
    for (const Setting& setting : settings_.all()) names.push_back(variable_of(setting));
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (const auto& [name, value] : written_.variables) {
      if (!name.starts_with(kPrefix) || std::ranges::find(known, name) != known.end()) continue;
      faults_.warnings.push_back("the environment variable " + name + " is not used" +
                                 suggestion(name, known));
    }
  }

  void check() {
    for (const SettingFault& fault : settings_.failed_checks()) {
      const auto origin = origins_.find(fault.key);
      // What is missing is missing from the file, if there is one.
      const bool of_file =
          origin == origins_.end() ? written_.file.has_value() : origin->second.is_file;
      const std::string place = origin != origins_.end() ? origin->second.name
                                : of_file ? written_.file->string() + ": " + fault.key
                                          : flag_of(fault.key);
      (of_file ? faults_.file : faults_.usage).push_back(place + ": " + fault.text);
    }
  }

  std::string flag_of(const std::string& key) const {
    const Setting* setting = settings_.find(key);
    return setting != nullptr ? setting->flag : key;
  }

  const Settings& settings_;
  const Written& written_;
  WrittenFaults faults_;
  std::map<std::string, Origin> origins_;
};

}  // namespace

WrittenFaults configure(const Settings& settings, const Written& written) {
  return Configuration(settings, written).read();
}

std::map<std::string, std::string> process_environment() {
  std::map<std::string, std::string> variables;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) continue;
    variables.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  return variables;
}

}  // namespace accord
