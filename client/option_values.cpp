#include "client/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>

#include "common/io/words.h"

namespace accord {
namespace {

// The number that the whole text spells.
template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> items;
  while (true) {
    const std::size_t comma = list.find(',');
    items.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) return items;
    list.remove_prefix(comma + 1);
  }
}

std::string unknown_solver(const std::string& name, const std::vector<std::string>& known_names) {
  const std::vector<std::string_view> known(known_names.begin(), known_names.end());
  return fmt::format("there is no solver {}; expected {}", in_quotes(name), alternatives(known));
}

}  // namespace

CLI::Validator plain_integer() {
  const auto check = [](std::string& text) -> std::string {
    const std::optional<std::uint64_t> value = number_in<std::uint64_t>(text);
    if (!value) return in_quotes(text) + " is not an integer from 0 to 2^64 - 1 in decimal digits";
    text = std::to_string(*value);
    return {};
  };
  return {check, ""};
}

CLI::Validator seconds_within(double least, double most) {
  const auto check = [least, most](std::string& text) -> std::string {
    const std::optional<double> value = number_in<double>(text);
    if (value && std::isfinite(*value) && *value >= least && *value <= most) return {};
    return fmt::format("{} is not a number from {:g} to {:g}", in_quotes(text), least, most);
  };
  return {check, fmt::format("in [{:g} - {:g}]", least, most)};
}

CLI::Validator output_name() {
  const auto check = [](std::string& text) -> std::string {
    return text.empty() ? "the name of the file to write is empty" : "";
  };
  return {check, ""};
}

std::vector<std::string> solvers_in(std::string_view list,
                                    const std::vector<std::string>& known_names) {
  const auto refuse = [](const std::string& why) { throw CLI::ValidationError("--solvers", why); };
  std::vector<std::string> names;
  for (std::string& name : split(list)) {
    if (name.empty()) refuse(fmt::format("a name is empty in {}", in_quotes(list)));
    if (std::ranges::find(known_names, name) == known_names.end()) {
      refuse(unknown_solver(name, known_names));
    }
    if (std::ranges::find(names, name) != names.end()) refuse(in_quotes(name) + " is there twice");
    names.push_back(std::move(name));
  }
  return names;
}

void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code error;  // set where one of them does not exist: they are not the same, then
    if (!std::filesystem::equivalent(output, input, error)) continue;
    throw CLI::ValidationError("--output", fmt::format("{} is the same file as {}, which is read",
                                                       in_quotes(output), in_quotes(input)));
  }
}

}  // namespace accord
