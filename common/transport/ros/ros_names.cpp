#include "common/transport/ros/ros_names.h"

#include <algorithm>
#include <set>

namespace accord {
namespace {

constexpr std::size_t kLongest = 128;  // bytes; DDS takes 255 of a topic's name

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// The nearest that is a token.
std::string token_for(std::string_view robot) {
  std::string token;
  for (const char c : robot.substr(0, kLongest - 8)) {
    const char kept = is_digit(c) || is_letter(c) ? c : '_';
    if (kept != '_' || token.empty() || token.back() != '_') token += kept;
  }
  if (token.empty() || is_digit(token.front()) || token == "_") token.insert(0, "robot_");
  while (token.ends_with('_')) token.pop_back();
  return token;
}

}  // namespace

bool is_ros_token(std::string_view text) {
  if (text.empty() || is_digit(text.front())) return false;
  if (text.find("__") != std::string_view::npos) return false;
  return std::ranges::all_of(text, [](char c) { return is_digit(c) || is_letter(c) || c == '_'; });
}

bool is_ros_name(std::string_view text) {
  if (text.size() > kLongest) return false;
  while (true) {
    const std::size_t end = text.find('/');
    if (!is_ros_token(text.substr(0, end))) return false;
    if (end == std::string_view::npos) return true;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string> ros_tokens(const std::vector<std::string>& robots) {
  std::vector<std::string> tokens;
  std::set<std::string> taken;
  for (const std::string& robot : robots) {
    const std::string first = token_for(robot);
    std::string token = first;
    for (int number = 2; !taken.insert(token).second; ++number) {
      token = first + "_" + std::to_string(number);
    }
    tokens.push_back(std::move(token));
  }
  return tokens;
}

}  // namespace accord
