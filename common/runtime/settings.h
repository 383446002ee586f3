// What a process can be told: one table, from which its configuration file, its environment
// variables, its flags and its help are read (configuration.h, command_line.h).
//
// Every setting is bound to a variable of the process, which holds the default until something else
// is read. Not thread safe; filled and read while a process starts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/runtime/notation.h"

namespace accord {

struct Setting {
  std::string key;          // in the file, levels joined by dots: "dds.domain"
  std::string flag;         // "--domain"
  std::string help;         // what it decides, as a phrase
  std::string expected;     // what a value is: "a whole number from 0 to 232"; of a list: an item
  std::string placeholder;  // for a value, in a list of flags
  std::string initial;      // the default, as a person would write it
  bool is_text = false;     // a file may put values in quotes
  bool is_list = false;  // a list in the file, commas in a variable, a flag given again and again

  std::function<bool(std::string_view)> accepts;                // one value, or one item
  std::function<void(const std::vector<std::string>&)> assign;  // requires: all are accepted; one,
                                                                // unless it is a list
};

// The environment variable of a setting: "dds.domain" is ACCORD_DDS_DOMAIN.
std::string variable_of(const Setting& setting);

// What is wrong with settings that make sense one by one, and with which of them.
struct SettingFault {
  std::string key;
  std::string text;  // what is wrong and what was expected
};

class Settings {
 public:
  // Binds `target`, whose value is the default and which must outlive the table. Returns the new
  // setting, for defaults that are better said in words than by what they are on this machine;
  // the reference holds until the next one is added. Requires: key and flag are new; a key with
  // further levels is no setting itself.
  template <typename T>
  Setting& add(std::string key, std::string flag, T& target, Notation<T> notation,
               std::string help);
  template <typename T>
  Setting& add_list(std::string key, std::string flag, std::vector<T>& target, Notation<T> notation,
                    std::string help);

  // Looked at when everything has been read and is sound by itself.
  void add_check(std::function<std::optional<SettingFault>()> check) {
    checks_.push_back(std::move(check));
  }

  const std::vector<Setting>& all() const& { return all_; }  // in the order of adding
  void all() && = delete;                                    // they would be gone
  const Setting* find(std::string_view key) const;           // nullptr: there is none
  std::vector<SettingFault> failed_checks() const;

 private:
  std::vector<Setting> all_;
  std::vector<std::function<std::optional<SettingFault>()>> checks_;
};

template <typename T>
Setting& Settings::add(std::string key, std::string flag, T& target, Notation<T> notation,
                       std::string help) {
  Setting setting;
  setting.key = std::move(key);
  setting.flag = std::move(flag);
  setting.help = std::move(help);
  setting.expected = notation.expected;
  setting.placeholder = notation.placeholder;
  setting.initial = notation.print(target);
  setting.is_text = notation.is_text;
  setting.accepts = [notation](std::string_view text) { return notation.parse(text).has_value(); };
  setting.assign = [notation, &target](const std::vector<std::string>& texts) {
    if (auto value = notation.parse(texts.front())) target = std::move(*value);
  };
  return all_.emplace_back(std::move(setting));
}

template <typename T>
Setting& Settings::add_list(std::string key, std::string flag, std::vector<T>& target,
                            Notation<T> notation, std::string help) {
  Setting setting;
  setting.key = std::move(key);
  setting.flag = std::move(flag);
  setting.help = std::move(help);
  setting.expected = notation.expected;
  setting.placeholder = notation.placeholder;
  for (const T& item : target) {
    setting.initial += (setting.initial.empty() ? "" : ",") + notation.print(item);
  }
  if (target.empty()) setting.initial = "none";
  setting.is_text = notation.is_text;
  setting.is_list = true;
  setting.accepts = [notation](std::string_view text) { return notation.parse(text).has_value(); };
  setting.assign = [notation, &target](const std::vector<std::string>& texts) {
    target.clear();
    for (const std::string& text : texts) {
      if (auto value = notation.parse(text)) target.push_back(std::move(*value));
    }
  };
  return all_.emplace_back(std::move(setting));
}

}  // namespace accord
