#include "common/runtime/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>
#include <string_view>

#include "common/io/words.h"
#include "common/runtime/configuration.h"

namespace accord {
namespace {

constexpr const char* kConfigFlag = "--config";
constexpr const char* kConfigVariable = "ACCORD_CONFIG";

constexpr const char* kFooter = R"(
What is given in several places: a flag counts more than an environment variable, a variable more
than the file. docs/operations.md says more.

Exit codes:
  0  ended in order, when asked to
  1  a bug in accord, or not enough memory
  2  a flag or an environment variable makes no sense
  3  the configuration file cannot be read, or is wrong
  4  what is needed of the machine is not to be had: the bus, a port, a folder)";

std::string description_of(const Setting& setting) {
  return setting.help + "\n" + setting.expected + (setting.is_list ? "; may be repeated" : "") +
         "\n[default: " + setting.initial + "; in the file: " + setting.key + "; " +
         variable_of(setting) + "]";
}

// Texts as they stand: what they mean is not CLI11's to decide, and how often they may be given
// neither.
void add_flag(CLI::App& app, const std::string& flag, const std::string& placeholder,
              const std::string& description, std::vector<std::string>& texts) {
  app.add_option(
         flag,
         [&texts](const CLI::results_t& results) {
           texts = results;
           return true;
         },
         description)
      ->type_name(placeholder)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<std::string> faults_of_rest(const CLI::App& app, const Settings& settings) {
  std::vector<std::string_view> known{kConfigFlag, "--help", "--version"};
  for (const Setting& setting : settings.all()) known.push_back(setting.flag);
  std::vector<std::string> faults;
  bool after_unknown = false;  // its value, most likely
  for (const std::string& word : app.remaining()) {
    if (word.starts_with('-')) {
      const std::string flag = word.substr(0, word.find('='));
      faults.push_back(flag + ": unknown flag" + suggestion(flag, known));
      after_unknown = word.find('=') == std::string::npos;
    } else {
      if (!after_unknown) faults.push_back(in_quotes(word) + ": expected a flag");
      after_unknown = false;
    }
  }
  return faults;
}

std::string lines_of(const std::vector<std::string>& faults) {
  std::string lines;
  for (const std::string& fault : faults) lines += fault + "\n";
  return lines;
}

}  // namespace

Start read_command_line(const Program& program, const Settings& settings, int argc,
                        const char* const* argv,
                        const std::map<std::string, std::string>& environment) {
  CLI::App app(program.purpose, program.name);
  app.set_version_flag("--version", program.version);
  app.footer(kFooter);
  app.allow_extras();
  std::vector<std::string> files;
  std::map<std::string, std::vector<std::string>> flags;
  add_flag(app, kConfigFlag, "FILE",
           std::string("Configuration file, of YAML\n[") + kConfigVariable + "]", files);
  for (const Setting& setting : settings.all()) {
    add_flag(app, setting.flag, setting.placeholder, description_of(setting), flags[setting.flag]);
  }
  Start start;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream output, errors;
    const bool asked_for = app.exit(error, output, errors) == 0;
    start.end = asked_for ? ProcessExit::kEnded : ProcessExit::kUsage;
    start.output = output.str();
    start.errors = errors.str();
    return start;
  }
  std::erase_if(flags, [](const auto& entry) { return entry.second.empty(); });

  Written written{std::nullopt, environment, std::move(flags)};
  if (const auto named = environment.find(kConfigVariable); named != environment.end()) {
    if (!named->second.empty()) written.file = named->second;
    written.variables.erase(kConfigVariable);
  }
  if (!files.empty()) written.file = files.back();
  WrittenFaults faults = configure(settings, written);
  std::vector<std::string> usage = faults_of_rest(app, settings);
  if (files.size() > 1) {
    usage.push_back(std::string(kConfigFlag) + ": given " + std::to_string(files.size()) +
                    " times; expected once");
  }
  std::ranges::move(faults.usage, std::back_inserter(usage));
  start.warnings = std::move(faults.warnings);
  start.errors = lines_of(usage) + lines_of(faults.file);
  if (!usage.empty()) {
    start.errors += "Run " + program.name + " --help for more information.\n";
    start.end = ProcessExit::kUsage;
  } else if (!faults.file.empty()) {
    start.end = ProcessExit::kBadFile;
  }
  return start;
}

Start start_up(const Program& program, const Settings& settings, int argc,
               const char* const* argv) {
  Start start = read_command_line(program, settings, argc, argv, process_environment());
  std::cout << start.output << std::flush;
  std::cerr << start.errors;
  return start;
}

}  // namespace accord
