#include "common/runtime/settings_file.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

#include "common/io/document.h"
#include "common/io/fields.h"
#include "common/io/files.h"
#include "common/io/limits.h"
#include "common/io/words.h"
#include "common/io/yaml_reader.h"

namespace accord {
namespace {

// Nothing but blank lines and comments, which is no YAML document, but a file that changes nothing.
bool says_nothing(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && line[first] != '#') return false;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return true;
}

class Reader {
 public:
  Reader(const Settings& settings, Faults& faults) : settings_(settings), faults_(faults) {}

  // All settings whose keys begin with `prefix`: "" for the whole file, "dds." for a section of it.
  void read_section(const Value& map, const std::string& prefix) {
    const std::string_view section =
        std::string_view(prefix).substr(0, prefix.empty() ? 0 : prefix.size() - 1);
    const std::vector<std::string_view> names = names_after(prefix);
    const Fields fields(map, section.empty() ? "the settings" : section, names, faults_);
    for (const std::string_view name : names) {
      const auto value = fields.find(name);
      if (!value) continue;
      const std::string key = prefix + std::string(name);
      if (const Setting* setting = settings_.find(key)) {
        read_setting(*value, *setting);
      } else if (expect_map(*value, "a map of settings", faults_)) {
        read_section(*value, key + ".");
      }
    }
  }

  std::vector<FileEntry> take() { return std::move(entries_); }

 private:
  // The next level of the keys that begin with `prefix`, each once.
  std::vector<std::string_view> names_after(const std::string& prefix) const {
    std::vector<std::string_view> names;
    for (const Setting& setting : settings_.all()) {
      std::string_view rest = setting.key;
      if (!rest.starts_with(prefix)) continue;
      rest.remove_prefix(prefix.size());
      rest = rest.substr(0, rest.find('.'));
      if (std::ranges::find(names, rest) == names.end()) names.push_back(rest);
    }
    return names;
  }

  void read_setting(const Value& value, const Setting& setting) {
    std::vector<std::string> values;
    bool sound = true;
    const auto add = [&](const Value& item) {
      const bool may_be = item.kind() == ValueKind::kPlain ||
                          (setting.is_text && item.kind() == ValueKind::kQuoted);
      if (may_be && setting.accepts(item.text())) {
        values.emplace_back(item.text());
      } else {
        fault_at(item, "expected " + setting.expected + ", not " + item.in_words(), faults_);
        sound = false;
      }
    };
    if (!setting.is_list) {
      add(value);
    } else if (value.is_list()) {
      for (const Value item : value) add(item);
    } else {
      fault_at(value,
               "expected a list, each item " + setting.expected + ", not " + value.in_words(),
               faults_);
      sound = false;
    }
    if (sound) entries_.push_back({&setting, std::move(values), place_of(value)});
  }

  const Settings& settings_;
  Faults& faults_;
  std::vector<FileEntry> entries_;
};

}  // namespace

std::vector<FileEntry> read_settings_file(const Settings& settings,
                                          const std::filesystem::path& file, Faults& faults) {
  const auto text = read_file(file, limits::kSettingsBytes);
  if (!text) {
    faults.add(file.string(), 0, "", text.error());
    return {};
  }
  if (says_nothing(*text)) return {};
  const auto document = read_yaml(*text, file.string(), limits::kSettingsNodes, faults);
  if (!document || document->root().is_null()) return {};
  Reader reader(settings, faults);
  if (expect_map(document->root(), "a map of settings", faults)) {
    reader.read_section(document->root(), "");
  }
  return reader.take();
}

}  // namespace accord
